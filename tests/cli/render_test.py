import json
import os
import re
import signal
import struct
import subprocess
import time
import unittest

from command_line import CommandLineTest, PROGRAM, main

SMALL = ["--resolution", "32x32", "--spp", "4"]


class Render(CommandLineTest):
    def test_no_argument_renders_the_cornell_box(self):
        done = self.lambert("render", *SMALL)
        self.assertEqual(self.files(), ["out.png"])
        self.assertEqual(done.stdout.strip(), str(self.folder / "out.png"))

    def test_every_output_format(self):
        names = ["a.exr", "a.hdr", "a.pfm", "a.png", "a.jpg", "a.tif"]
        self.lambert("render", *SMALL, *[w for n in names for w in ("-o", n)])
        self.assertEqual(self.files(), sorted(names))

    def test_statistics(self):
        self.lambert("render", *SMALL, "--stats", "s.json")
        stats = self.json("s.json")
        self.assertEqual(stats["samples"], 32 * 32 * 4)
        self.assertGreater(stats["rays"], stats["samples"])

    def test_same_seed_same_file(self):
        self.lambert("render", *SMALL, "--threads", 1, "-o", "a.exr")
        self.lambert("render", *SMALL, "--threads", 2, "-o", "b.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_progress_for_machines(self):
        done = self.lambert("render", *SMALL, "--progress", "ndjson")
        lines = [json.loads(line) for line in done.stderr.splitlines()]
        self.assertEqual(lines[-1]["fraction"], 1)

    def test_a_layer_named_twice_is_there_once(self):
        for twice, once in (("albedo,albedo", "albedo"), ("all,albedo", "all")):
            self.lambert("render", *SMALL, "--aov", twice, "-o", "twice.exr")
            self.lambert("render", *SMALL, "--aov", once, "-o", "once.exr")
            self.assertEqual((self.folder / "twice.exr").read_bytes(), (self.folder / "once.exr").read_bytes())

    def test_extensions_may_be_capital(self):
        self.assertEqual(self.lambert("render", *SMALL, "--aov", "all", "-o", "a.EXR").stderr, "")
        self.assertIn("none is written", self.lambert("render", *SMALL, "--aov", "all", "-o", "a.png").stderr)

    def test_time_limit(self):
        start = time.monotonic()
        self.lambert("render", "--time-limit", "0.5", "--resolution", "64x64")
        self.assertLess(time.monotonic() - start, 20)


def blocked_signals(*pending):
    """For the new process: signals wait until it takes them, so that none comes too early; `pending` have come already."""
    def prepare():
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
        for each in pending:
            os.kill(os.getpid(), each)
    return prepare


class Interrupt(CommandLineTest):
    ENDLESS = ["render", "--spp", "1000000", "--resolution", "64x64", "-o", "i.exr"]

    def test_saves_and_says_130(self):
        process = subprocess.Popen([PROGRAM, *self.ENDLESS, "--progress", "ndjson"], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        while json.loads(process.stderr.readline())["samples"] == 0:
            pass
        process.send_signal(signal.SIGINT)
        _, words = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 130)
        self.assertIn("what was done is saved", words)
        self.assertEqual(self.files(), ["i.exr"])

    def test_before_the_first_sample_writes_nothing(self):
        # Takes longer to read than a signal to arrive.
        (self.folder / "s.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 500000)
        (self.folder / "s.exr").write_text("old")
        for each in (signal.SIGINT, signal.SIGTERM):
            done = subprocess.run([PROGRAM, "render", "s.obj", *SMALL, "-o", "s.exr", "--stats", "s.json"], cwd=self.folder,
                                  capture_output=True, text=True, timeout=60, preexec_fn=blocked_signals(each))
            self.assertEqual(done.returncode, 130)
            self.assertEqual(done.stdout, "")
            self.assertIn("nothing is written", done.stderr)
            self.assertNotIn("saved", done.stderr)
            self.assertEqual((self.folder / "s.exr").read_text(), "old")
            self.assertEqual(self.files(), ["s.exr", "s.obj"])

    def test_the_second_ends_the_process_at_once(self):
        # Standard error takes no more, so that the program hangs in its first word of progress or of farewell.
        reader, full = os.pipe()
        os.set_blocking(full, False)
        try:
            while True:
                os.write(full, bytes(4096))
        except BlockingIOError:
            os.set_blocking(full, True)
        process = subprocess.Popen([PROGRAM, *self.ENDLESS, "--progress", "ndjson"], cwd=self.folder, stderr=full,
                                   preexec_fn=blocked_signals())
        try:
            for _ in range(50):  # two that come at once count as one
                process.send_signal(signal.SIGINT)
                try:
                    process.wait(timeout=0.2)
                    break
                except subprocess.TimeoutExpired:
                    pass
            self.assertEqual(process.poll(), 130)
        finally:
            process.kill()
            process.wait()
            os.close(reader)
            os.close(full)
        self.assertEqual(self.files(), [])


class Outputs(CommandLineTest):
    def refused(self, path, why):
        # Before any work: the scene that is missing is not missed.
        for flags in (["-o", path], ["-o", "a.exr", "-o", path], ["-o", "a.exr", "--stats", path]):
            done = self.lambert("render", "missing.glb", *flags, status=1)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(str(path), done.stderr)
            self.assertIn(why, done.stderr)

    def test_are_checked_before_any_work(self):
        (self.folder / "folder.png").mkdir()
        os.mkfifo(self.folder / "pipe.png")
        before = self.files()
        self.refused("folder.png", "it is a folder")
        self.refused("pipe.png", "not a regular file")
        self.refused("none/a.png", "there is no folder")
        self.refused("/proc/a.png", "cannot write")
        self.refused("n" * 252 + ".png", "cannot write")
        self.assertEqual(self.files(), before)

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_a_folder_without_permission(self):
        (self.folder / "locked").mkdir(mode=0o555)
        self.refused("locked/a.png", "ermission")

    def test_one_that_fails_does_not_stop_the_others(self):
        # WebP has at most 16383 pixels a side.
        done = self.lambert("render", "--resolution", "16384x1", "--spp", 1, "-o", "a.webp", "-o", "a.pfm", "--stats", "s.json", status=1)
        self.assertIn("a.webp", done.stderr)
        self.assertEqual(done.stdout.strip(), str(self.folder / "a.pfm"))
        self.assertEqual(self.files(), ["a.pfm", "s.json"])

    def test_long_names(self):
        name = "n" * 245 + ".png"
        self.lambert("render", *SMALL, "-o", name)
        self.assertEqual(self.files(), [name])

    def test_links_are_written_through(self):
        (self.folder / "there").mkdir()
        (self.folder / "link.png").symlink_to("there/target.png")
        for _ in range(2):
            self.lambert("render", *SMALL, "-o", "link.png")
            self.assertTrue((self.folder / "link.png").is_symlink())
            self.assertFalse((self.folder / "there" / "target.png").is_symlink())
            self.assertTrue((self.folder / "there" / "target.png").read_bytes().startswith(b"\x89PNG"))


class Environment(CommandLineTest):
    BLACK_BALL = 'Camera "perspective"\nWorldBegin\nTranslate 0 0 3\nMaterial "diffuse" "rgb reflectance" [ 0 0 0 ]\nShape "sphere"\n'

    def corner_pixel(self, *arguments):
        (self.folder / "ball.pbrt").write_text(self.BLACK_BALL)
        self.lambert("render", "ball.pbrt", *SMALL, *arguments, "-o", "ball.pfm")
        return struct.unpack("<3f", (self.folder / "ball.pfm").read_bytes()[-12:])

    def test_an_image_is_seen_all_around(self):
        (self.folder / "sky.pfm").write_bytes(b"PF\n2 1\n-1.0\n" + struct.pack("<6f", 1, 2, 3, 1, 2, 3))
        for seen, expected in zip(self.corner_pixel("--environment", "sky.pfm"), (1, 2, 3)):
            self.assertAlmostEqual(seen, expected, places=4)

    # rows: IS-19
    def test_openexrs_attribute_is_read(self):
        rows = [(1, 0.5, 0.25) if 8 <= x < 24 else (0.25, 2, 4) for _ in range(16) for x in range(32)]
        (self.folder / "sky.pfm").write_bytes(b"PF\n32 16\n-1.0\n" + b"".join(struct.pack("<3f", *c) for c in rows))
        expected = self.corner_pixel("--environment", "sky.pfm")
        for layout in ("openexr-lat-long", "openexr-cube"):
            self.lambert("probe", "convert", "sky.pfm", "--to", layout, "--size", 32, "-o", "turned.exr")
            for seen, want in zip(self.corner_pixel("--environment", "turned.exr"), expected):
                self.assertAlmostEqual(seen, want, places=3, msg=layout)

    def test_pixels_that_are_not_finite_are_filled(self):
        (self.folder / "sky.pfm").write_bytes(b"PF\n2 1\n-1.0\n" + struct.pack("<6f", 1, 2, 3, 1, float("nan"), 3))
        for seen, expected in zip(self.corner_pixel("--environment", "sky.pfm"), (1, 2, 3)):
            self.assertAlmostEqual(seen, expected, places=4)

    def test_studio(self):
        self.assertGreater(min(self.corner_pixel("--environment", "studio")), 0)

    def test_a_file_that_is_no_image(self):
        (self.folder / "sky.hdr").write_text("no image")
        self.assertIn("sky.hdr", self.lambert("render", "--environment", "sky.hdr", status=1).stderr)


class Framing(CommandLineTest):
    GLOWING = ('WorldBegin AreaLightSource "diffuse" "rgb L" [ 1 1 1 ]\nShape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ]\n'
               '"point3 P" [ {0} {1} 0  -{0} {1} 0  -{0} -{1} 0  {0} -{1} 0 ]\n')

    def test_is_for_the_resolution_asked_for(self):
        for shape, (width, height) in ((("5", "1"), (40, 40)), (("1", "5"), (120, 40))):
            (self.folder / "glow.pbrt").write_text(self.GLOWING.format(*shape))
            self.lambert("render", "glow.pbrt", "--resolution", f"{width}x{height}", "--spp", 1, "--filter", "box", "-o", "glow.pfm")
            red = struct.unpack(f"<{3 * width * height}f", (self.folder / "glow.pfm").read_bytes()[-12 * width * height:])[::3]
            rows = [red[y * width:][:width] for y in range(height)]
            self.assertGreater(max(red), 0)
            self.assertEqual(max(*rows[0], *rows[-1], *(row[0] for row in rows), *(row[-1] for row in rows)), 0)


class Order(CommandLineTest):
    def test_options_may_stand_before_the_scene(self):
        (self.folder / "ball.pbrt").write_text(DefaultOutput.SCENE)
        self.lambert("render", "-o", "a.png", "-o", "b.png", "--aov", "albedo,depth", "--set", "max-depth=2", "ball.pbrt", *SMALL)
        self.assertEqual(self.files(), ["a.png", "b.png", "ball.pbrt"])


class DefaultOutput(CommandLineTest):
    SCENE = 'Camera "perspective"\nFilm "rgb" "integer xresolution" 8 "integer yresolution" 8\nWorldBegin\nShape "sphere"\n'

    def test_is_beside_the_scene_and_may_be_made_again(self):
        (self.folder / "ball.pbrt").write_text(self.SCENE)
        for _ in range(2):
            done = self.lambert("render", "ball.pbrt", "--spp", 1)
            self.assertEqual(done.stdout.strip(), str(self.folder / "ball.png"))

    def test_does_not_replace_a_texture_of_the_same_name(self):
        (self.folder / "ball.pbrt").write_text(self.SCENE)
        (self.folder / "ball.png").write_bytes(b"a texture")
        done = self.lambert("render", "ball.pbrt", "--spp", 1, status=1)
        self.assertIn("ball.png exists", done.stderr)
        self.assertEqual((self.folder / "ball.png").read_bytes(), b"a texture")


class Mistakes(CommandLineTest):
    def expect(self, words, *arguments, status=1):
        done = self.lambert(*arguments, status=status)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(self.files(), [])

    def test_unknown_words_name_the_known_ones(self):
        self.expect(["'pth'", "did you mean 'path'"], "render", "--method", "pth")
        self.expect(["max-dept", "max-depth"], "render", "--set", "max-dept=3")
        self.expect(["sobl", "sobol"], "render", "--sampler", "sobl")
        self.expect(["bix", "box"], "render", "--filter", "bix")
        self.expect(["albdo", "albedo"], "render", "--aov", "albdo")
        self.expect([".xyz", ".exr"], "render", "-o", "a.xyz")
        self.expect(["nowhere"], "render", "-o", "nowhere/a.png")

    def test_wrong_numbers(self):
        self.expect(["--resolution", "32y32"], "render", "--resolution", "32y32")
        self.expect(["--crop"], "render", "--crop", "1,2,3")
        self.expect(["crop"], "render", "--resolution", "8x8", "--crop", "0,0,9,9")
        self.expect(["--spp"], "render", "--spp", "0")
        self.expect(["max-depth", "whole number"], "render", "--set", "max-depth=three")

    def test_numbers_out_of_range(self):
        never = ("nan", "inf", "-inf", "1e400")
        for flag, words in {"--threads": ("-1", "1000000000", *never), "--seed": ("-1", "18446744073709551616", *never),
                            "--spp": ("-1", "0", "99999999999", *never), "--pass-size": ("-1", *never),
                            "--time-limit": ("-1", *never), "--target-error": ("-0.1", *never), "--time": ("-1", "1e39", *never),
                            "--exposure": ("-1e39", "1000", *never)}.items():
            for word in words:
                with self.subTest(flag=flag, word=word):
                    done = self.lambert("render", flag, word, status=1)
                    self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                    self.assertRegex(done.stderr, f"error: {flag}: expected a .*, got '{re.escape(word)}'")
                    self.assertEqual(self.files(), [])
        self.expect(["--time", "'nan'"], "info", "--time", "nan")
        self.expect(["--threads"], "render", "--threads", "many", status=2)

    def test_numbers_at_the_end_of_their_range(self):
        self.lambert("render", *SMALL, "--seed", 2**64 - 1, "--threads", 4096, "--exposure", -99.5, "--time", 0, "-o", "a.png")

    def test_missing_file(self):
        self.expect(["missing.glb"], "render", "missing.glb")

    def test_usage_errors_are_2(self):
        self.expect(["--no-such-flag"], "render", "--no-such-flag", status=2)
        self.expect([], "no-such-command", status=2)


class Words(CommandLineTest):
    def test_help_of_a_command(self):
        self.assertEqual(self.lambert("help").stdout, self.lambert("--help").stdout)
        self.assertEqual(self.lambert("help", "polygon", "union").stdout, self.lambert("polygon", "union", "--help").stdout)

    def test_help_version_methods_completion(self):
        self.assertIn("--target-error", self.lambert("render", "--help").stdout)
        self.assertRegex(self.lambert("--version").stdout, r"^lambert \d+\.\d+\.\d+\n$")
        self.assertIn("max-depth", self.lambert("methods").stdout)
        for shell in ("bash", "zsh", "fish"):
            self.assertIn("render", self.lambert("completion", shell).stdout)
        self.assertIn("spp", self.lambert("completion", "fish").stdout)

    def test_bash_completion_is_valid(self):
        script = self.lambert("completion", "bash").stdout
        subprocess.run(["bash", "-n"], input=script, text=True, check=True)

    def test_info(self):
        self.assertIn("triangles", self.lambert("info").stdout)


if __name__ == "__main__":
    main()
