"""lambert composite on pictures with known answers, on sequences, and beside oiiotool."""
import json
import shutil
import subprocess
import unittest

from command_line import SOURCE, CommandLineTest, main

OIIOTOOL = shutil.which("oiiotool")
WINDOWS = SOURCE.parent / "shared" / "data" / "compositing" / "openexr-images" / "DisplayWindow"


class Compositing(CommandLineTest):
    def composite(self, expression, *arguments, status=0):
        return self.lambert("composite", expression, *arguments, status=status)


class Composite(Compositing):
    def shape(self, name, expression, size="16x8"):
        self.composite(expression, "--resolution", size, "-o", name)

    def test_writes_and_prints_paths(self):
        done = self.composite("disk(8,4,3)", "--resolution", "16x8", "-o", "a.exr", "-o", "a.png")
        self.assertEqual([line.split("/")[-1] for line in done.stdout.split()], ["a.exr", "a.png"])

    def test_trees_print_and_read_back(self):
        text = 'a.exr over b.exr blur [1:0 9:3] mask disk(1, 2, 3)'
        tree = self.composite(text, "--print", "json").stdout
        self.assertEqual(json.loads(tree)["word"], "over")
        (self.folder / "tree.json").write_text(tree)
        self.assertEqual(self.composite("tree.json", "--print", "text").stdout.strip(), text)

    def test_sequences(self):
        for frame in (1, 2, 3):
            self.shape(f"plate.{frame:04d}.exr", f"colour({frame},0,0)")
        done = self.composite("disk([1:0 3:16],4,3) over plate.####.exr", "--frames", "1-3x2", "-o", "out.%02d.exr")
        self.assertEqual(len(done.stdout.split()), 2)
        self.assertIn("out.03.exr", self.files())
        missing = self.composite("plate.####.exr", "--frames", "1-9", "-o", "late.####.exr", status=1)
        self.assertIn("plate.0004.exr: there is no such file (plate.####.exr at frame 4)", missing.stderr)
        self.assertFalse([f for f in self.files() if f.startswith("late")], "nothing is written before all is there")

    def test_errors(self):
        self.shape("a.exr", "disk(8,4,3)")
        for expression, words in {"a.exr ovre a.exr": "expression:1:7: expected an operator or the end, found 'ovre'; did you mean 'over'?",
                                  "a.exr over b.exr": "b.exr: there is no such file", "a.exr layer x": "no layer 'x'",
                                  "a.exr zover a.exr": "neither of its elements has a channel Z",
                                  "a.####.exr": "say which frames"}.items():
            done = self.composite(expression, "-o", "out.exr", status=1)
            self.assertIn(words, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn("resolution", self.composite("disk(1,1,1)", "-o", "out.exr", status=1).stderr)
        self.assertIn("####", self.composite("a.exr", "--frames", "1-2", "-o", "out.exr", status=1).stderr)
        self.composite("a.exr", "--depht", "half", status=2)
        self.assertNotIn("out.exr", self.files())
        for bad in sorted((SOURCE / "tests" / "corpora" / "composite").glob("bad-*")):
            done = self.composite(bad, "-o", "out.exr", status=1)
            self.assertIn(bad.name, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)


@unittest.skipUnless(OIIOTOOL, "oiiotool is not installed: agreement with OpenImageIO is NOT tested")
class BesideOiiotool(Compositing):
    def oiiotool(self, *arguments):
        return subprocess.run([OIIOTOOL, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)

    def expect_same(self, ours, theirs):
        done = self.oiiotool("--fail", "1e-6", "--diff", theirs, ours)
        self.assertIn("PASS", done.stdout, done.stdout + done.stderr)

    def noise(self, name, seed, channels="R,G,B,A"):
        count = len(channels.split(","))
        self.oiiotool("--create", "130x90", count, f"--noise:type=uniform:min=0:max=1:seed={seed}", "--chnames", channels, "-d", "float",
                      "-o", name)

    # rows: AA-29
    def test_operators(self):
        self.noise("a.exr", 1), self.noise("b.exr", 2)
        for ours, theirs in {"over": "over", "plus": "add", "minus": "sub", "multiply": "mul", "difference": "absdiff", "max": "max",
                             "min": "min"}.items():
            self.oiiotool("a.exr", "b.exr", f"--{theirs}", "-d", "float", "-o", "theirs.exr")
            self.composite(f"a.exr {ours} b.exr", "--depth", "float", "-o", "ours.exr")
            self.expect_same("ours.exr", "theirs.exr")

    def test_depth(self):
        self.noise("a.exr", 3, "R,G,B,A,Z"), self.noise("b.exr", 4, "R,G,B,A,Z")
        self.oiiotool("a.exr", "b.exr", "--zover", "-d", "float", "-o", "theirs.exr")
        self.composite("a.exr zover b.exr", "--depth", "float", "-o", "ours.exr")
        self.expect_same("ours.exr", "theirs.exr")

    @unittest.skipUnless(WINDOWS.exists(), "the OpenEXR images are not there: windows are NOT tested")
    def test_windows(self):
        for first, second in (("t01", "t05"), ("t08", "t02"), ("t07", "t03"), ("t09", "t12"), ("t13", "t14"), ("t15", "t16")):
            self.oiiotool(WINDOWS / f"{first}.exr", "--ch", "R,G,B,A=0.5", "-d", "float", "-o", "a.exr")
            self.oiiotool(WINDOWS / f"{second}.exr", "--ch", "R,G,B,A=1.0", "-d", "float", "-o", "b.exr")
            self.oiiotool("a.exr", "b.exr", "--over", "-d", "float", "-o", "theirs.exr")
            self.composite("a.exr over b.exr", "--depth", "float", "-o", "ours.exr")
            self.expect_same("ours.exr", "theirs.exr")


if __name__ == "__main__":
    main()
