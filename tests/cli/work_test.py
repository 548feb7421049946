"""--progress, --quiet and Ctrl-C, which are the same in every command that may take long."""
import json
import os
import signal
import subprocess
import time

from command_line import PROGRAM, CommandLineTest, main

WORKS = ["image convert a.pfm -o b.exr", "image resize a.pfm --size 2x2 -o b.exr", "image blur a.pfm --sigma 1 -o b.exr",
         "image resolve a.pfm --factor 1 -o b.exr", "image mipmap a.pfm -o b.exr",
         "image mipmap a.pfm --all -o b_#.exr -o c_#.pfm", "image fill-gaps a.pfm --mask a.pfm -o b.exr",
         "image plane --size 8x8 -o b.exr", "tonemap a.pfm -o b.png", "tonemap a.pfm --montage -o b.png", "denoise a.pfm -o b.exr",
         "denoise a.pfm --method nlm -o b.exr", "probe convert a.pfm --to octahedral -o b.exr", "probe rotate a.pfm --yaw 9 -o b.exr",
         "probe irradiance a.pfm --size 4 -o b.exr", "probe sh a.pfm --size 4 -o b.exr", "probe check a.pfm",
         "hdr expose a.pfm -o b.png", "hdr merge l.txt --response srgb -o b.exr", "hdr response l.txt --response srgb -o b.csv",
         "composite a.pfm -o b.exr", "composite a.pfm --frames 1-3 -o b.##.exr", "polygon union a.txt a.txt -o b.wkt",
         "render --resolution 8x8 --spp 4 -o b.exr"]


class Work(CommandLineTest):
    def setUp(self):
        super().setUp()
        (self.folder / "a.pfm").write_bytes(b"PF\n16 8\n-1\n" + b"\0\0\0\x3f" * (16 * 8 * 3))
        (self.folder / "a.txt").write_text("0 0\n4 0\n4 3\n")
        self.lambert("hdr", "expose", "a.pfm", "--bracket", "-2,0,2", "-o", "s_{}.png", "--list", "l.txt")

    def test_progress_for_machines_climbs_to_the_end(self):
        for work in WORKS:
            with self.subTest(work):
                words = self.lambert(*work.split(), "--progress", "ndjson").stderr
                lines = [json.loads(line) for line in words.splitlines() if line.startswith("{")]
                told = [line["fraction"] for line in lines]
                self.assertEqual(told, sorted(told))
                self.assertEqual(told[-1], 1)
                self.assertGreaterEqual(lines[-1]["elapsed_seconds"], 0)

    def test_bar_only_when_asked_for_or_on_a_terminal(self):
        for work in WORKS:
            with self.subTest(work):
                self.assertNotIn("%", self.lambert(*work.split()).stderr)
                self.assertNotIn("%", self.lambert(*work.split(), "--progress", "none").stderr)
                self.assertIn("100 %", self.lambert(*work.split(), "--progress", "tty").stderr)

    def test_quiet_says_nothing_but_prints_what_was_written(self):
        for work in WORKS:
            with self.subTest(work):
                loud = self.lambert(*work.split()).stdout
                done = self.lambert(*work.split(), "--quiet", "--progress", "ndjson")
                self.assertEqual((done.stdout, done.stderr), (loud, ""))
        done = self.lambert("tonemap", "none.exr", "-o", "b.png", "--quiet", status=1)
        self.assertIn("none.exr: cannot open", done.stderr)

    def test_many_levels_end_at_one(self):
        self.lambert("image", "plane", "--size", "512x512", "--lookup", "nearest", "-o", "big.exr")
        words = self.lambert("image", "mipmap", "big.exr", "--all", "-o", "l_#.pfm", "--progress", "ndjson").stderr
        self.assertEqual(json.loads(words.splitlines()[-1])["fraction"], 1)

    def test_what_follows_a_bar_stands_on_its_own_line(self):
        (self.folder / "cut.pfm").write_bytes((self.folder / "a.pfm").read_bytes()[:-1])
        for work in WORKS + ["tonemap cut.pfm -o b.png", "hdr expose cut.pfm -o b.png", "probe lights a.pfm --suns 1 --from mirror-ball",
                             "image mipmap a.pfm --level 900 -o b.exr", "tonemap a.pfm a.pfm cut.pfm --operator mertens -o b.png"]:
            with self.subTest(work):
                done = subprocess.run([PROGRAM, *work.split(), "--progress", "tty"], cwd=self.folder, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, text=True, errors="replace")
                for line in done.stdout.split("\n"):
                    if "\x1b[K" in line:
                        self.assertTrue(line.endswith("\x1b[K"), line)

    def test_unknown_style(self):
        for work in WORKS:
            with self.subTest(work):
                self.assertIn("--progress", self.lambert(*work.split(), "--progress", "dots", status=1).stderr)


class Interrupt(CommandLineTest):
    def interrupted(self, arguments, when, **settings):
        """Sends a signal once when(), and says what the command did."""
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   **settings)
        while not when(process):
            self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        out, words = process.communicate(timeout=30)
        return process.returncode, out, words

    def test_ends_at_once_and_leaves_nothing(self):
        self.lambert("render", "--resolution", "512x512", "--spp", "1", "--aov", "denoising", "-o", "n.exr", "--quiet")
        (self.folder / "b.exr").write_text("old")
        started = lambda process: process.stderr.readline().startswith("{")
        status, out, words = self.interrupted(["denoise", "n.exr", "--method", "nfor", "-o", "b.exr", "--progress", "ndjson"], started)
        self.assertEqual((status, out), (130, ""))
        self.assertIn("interrupted; nothing is written", words)
        self.assertEqual((self.folder / "b.exr").read_text(), "old")
        self.assertEqual(self.files(), ["b.exr", "n.exr"])

    def test_takes_away_what_is_being_written(self):
        # An OpenEXR file in bands: the temporary is there from the start.
        self.lambert("composite", "colour(0.5,0.25,0.1,1)", "--resolution", "16384x8192", "-o", "big.exr", "--quiet")
        writes = lambda process: any(name.startswith(".lambert") for name in self.files())
        status, out, words = self.interrupted(["image", "convert", "big.exr", "-o", "b.exr", "--compression", "dwaa"], writes)
        self.assertEqual((status, out), (130, ""))
        self.assertIn("interrupted; nothing is written", words)
        self.assertEqual(self.files(), ["big.exr"])

    def test_while_standard_input_says_nothing(self):
        reader, writer = os.pipe()
        start = time.monotonic()
        status, _, words = self.interrupted(["tonemap", "-", "-o", "b.png"], lambda process: time.monotonic() > start + 0.5, stdin=reader)
        os.close(reader), os.close(writer)
        self.assertEqual(status, 130)
        self.assertIn("interrupted; nothing is written", words)
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    main()
