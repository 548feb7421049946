"""`lambert compare`: verdicts, exit statuses, pictures."""
import json
import shutil
import struct
import subprocess
import unittest

from command_line import CommandLineTest, main


class Compare(CommandLineTest):
    def pfm(self, name, pixels, width):
        data = struct.pack(f"<{3 * len(pixels)}f", *(v for p in pixels for v in p))
        (self.folder / name).write_bytes(b"PF\n%d %d\n-1\n" % (width, len(pixels) // width) + data)

    def setUp(self):
        super().setUp()
        self.pfm("a.pfm", [(0.2, 0.4, 0.6)] * 64, 8)
        self.pfm("b.pfm", [(0.2, 0.4, 0.6)] * 63 + [(0.2, 0.4, 0.61)], 8)
        self.pfm("small.pfm", [(0, 0, 0)] * 6, 2)

    def test_same_images_are_the_same(self):
        self.assertIn("same", self.lambert("compare", "a.pfm", "a.pfm").stdout)

    def test_statuses_are_those_of_idiff(self):
        self.lambert("compare", "a.pfm", "b.pfm", status=2)
        self.lambert("compare", "a.pfm", "b.pfm", "--fail", 0.02, status=1)
        self.lambert("compare", "a.pfm", "b.pfm", "--fail", 0.02, "--warn", 0.02, status=0)
        self.lambert("compare", "a.pfm", "b.pfm", "--fail-percent", 2, "--warn-percent", 2, status=0)
        self.lambert("compare", "a.pfm", "b.pfm", "--fail-percent", 2, "--hard-fail", 0.005, status=2)
        self.assertIn("8x8", self.lambert("compare", "a.pfm", "small.pfm", status=3).stderr)
        self.assertIn("nowhere.exr", self.lambert("compare", "a.pfm", "nowhere.exr", status=4).stderr)

    @unittest.skipUnless(shutil.which("idiff"), "THE PEER IS MISSING: idiff is not installed")
    def test_idiff_agrees(self):
        for status, files, words in [
                (0, "a.pfm a.pfm", ""), (2, "a.pfm b.pfm", ""), (0, "a.pfm b.pfm", "-fail 0.02 -warn 0.02"),
                (0, "a.pfm b.pfm", "-failpercent 2 -warnpercent 2"), (2, "a.pfm b.pfm", "-failpercent 2 -hardfail 0.005"),
                (4, "a.pfm nowhere.exr", ""), (4, "nowhere.exr a.pfm", "")]:
            peer = subprocess.run(["idiff", *words.split(), *files.split()], cwd=self.folder, capture_output=True)
            self.assertEqual(peer.returncode, status, f"{files} {words}")
            ours = words.replace("percent", "-percent").replace("hardfail", "hard-fail").replace(" -", " --")
            self.lambert("compare", *files.split(), *(f"-{ours}".split() if ours else []), status=status)

    def test_says_what_is_not_compared(self):
        pixels = struct.pack("<16f", *([0.2, 0.4, 0.6, 1] * 4))
        (self.folder / "rgba.pfm").write_bytes(b"PF4\n2 2\n-1\n" + pixels)
        self.pfm("rgb.pfm", [(0.2, 0.4, 0.6)] * 4, 2)
        self.assertIn("not compared     A", self.lambert("compare", "rgba.pfm", "rgb.pfm").stdout)
        self.assertNotIn("not compared", self.lambert("compare", "rgba.pfm", "rgba.pfm").stdout)

    def test_json_says_where(self):
        said = json.loads(self.lambert("compare", "a.pfm", "b.pfm", "--json", status=2).stdout)
        self.assertAlmostEqual(said["max_error"], 0.01, 6)
        self.assertEqual(said["max_at"], {"x": 7, "y": 0, "channel": "B"})  # the rows of a PFM go upwards
        self.assertAlmostEqual(said["mse"], 1e-4 / 192, 9)
        self.assertEqual(said["pixels_over_fail"], 1)

    def test_a_metric_decides_when_named(self):
        self.lambert("compare", "a.pfm", "b.pfm", "--metric", "flip", "--fail", 0.5, "--warn", 0.5)
        self.lambert("compare", "a.pfm", "b.pfm", "--metric", "psnr", "--fail", 90, "--warn", 95, status=2)
        self.lambert("compare", "a.pfm", "b.pfm", "--metric", "nonsense", status=4)
        self.lambert("compare", "a.pfm", status=4)

    def test_pictures(self):
        self.lambert("compare", "a.pfm", "b.pfm", "--heat", "heat.png", "--difference", "difference.exr", status=2)
        self.lambert("compare", "a.pfm", "b.pfm", "--heat", "flip.png", "--heat-of", "flip", status=2)
        self.assertLessEqual({"heat.png", "flip.png", "difference.exr"}, set(self.files()))

    def test_z_test_judges_two_renderings(self):
        for name, seed in (("one.exr", 1), ("two.exr", 2)):
            self.lambert("render", "-o", name, "--resolution", "32x32", "--spp", 16, "--seed", seed, "--aov", "variance",
                         "--sampler", "independent", "--filter", "box")
        self.assertIn("same", self.lambert("compare", "one.exr", "two.exr", "--z-test").stdout)
        self.lambert("compare", "a.pfm", "b.pfm", "--z-test", status=4)


if __name__ == "__main__":
    main()
