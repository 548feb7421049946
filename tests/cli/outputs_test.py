"""Outputs are checked before any work: where one cannot be written, none is, and nothing is printed."""
import resource
import signal
import subprocess

from command_line import PROGRAM, CommandLineTest, main
from streams_test import PFM

# A command with an output that cannot be, and what is said of it.
REFUSED = [
    ("lab moire -o m.png -o m.svg", "m.svg: this picture is pixels"),
    ("lab comb -o m.png -o m.foo", "m.foo: unknown image format"),
    ("lab nyquist -o m.svg -o none/m.png", "none/m.png: cannot write: there is no folder"),
    ("hdr merge s_00.png s_01.png --stops 0,2 -o m.exr --plot p.foo", "p.foo: unknown image format"),
    ("hdr response s_00.png s_01.png --stops 0,2 -o m.csv --plot p.foo", "p.foo: unknown image format"),
    ("image plane --size 8x8 -o m.png -o m.foo", "m.foo: unknown image format"),
    ("probe find-ball a.pfm --circle 8,4,3 -o m.exr -o m.foo", "m.foo: unknown image format"),
    ("probe lights a.pfm --sky m.exr -o none/m.json", "none/m.json: cannot write: there is no folder"),
    ("probe lights a.pfm --sky m.exr --pbrt none/m.pbrt", "none/m.pbrt: cannot write: there is no folder"),
    ("probe lights a.pfm --sky m.foo --pbrt m.pbrt", "m.foo: unknown image format"),
    ("probe check a.pfm --irradiance 100 --restored m.foo", "m.foo: unknown image format"),
]


def small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024))


class Outputs(CommandLineTest):
    def setUp(self):
        super().setUp()
        (self.folder / "a.pfm").write_bytes(PFM)

    def test_all_are_checked_before_one_is_written(self):
        self.lambert("hdr", "expose", "a.pfm", "--bracket", "-2,0", "-o", "s_{}.png")
        before = self.files()
        for command, message in REFUSED:
            with self.subTest(command):
                done = self.lambert(*command.split(), status=1)
                self.assertIn(message, done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1)
                self.assertEqual(done.stdout, "")
                self.assertEqual(self.files(), before)

    def test_polygon(self):
        (self.folder / "p.wkt").write_text("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))")
        before = self.files()
        for words in ("union p.wkt -o u.wkt -o nodir/u.wkt", "extrude p.wkt -o e.obj -o nodir/e.obj",
                      "area p.wkt -o u.json --svg nodir/a.svg", "triangulate p.wkt -o e.obj -o nodir/t.wkt"):
            with self.subTest(words):
                done = self.lambert("polygon", *words.split(), status=1)
                self.assertIn("there is no folder", done.stderr)
                self.assertEqual(self.files(), before)

    def test_compare(self):
        for bad in ("--heat", "--difference"):
            good = "--difference" if bad == "--heat" else "--heat"
            done = self.lambert("compare", "a.pfm", "a.pfm", good, "d.png", bad, "h.foo", status=4)
            self.assertIn("h.foo: unknown image format", done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertEqual(self.files(), ["a.pfm"])

    def test_full_disk_names_the_output(self):
        self.lambert("image", "plane", "--size", "512x512", "-o", "p.exr")
        done = subprocess.run([PROGRAM, "image", "convert", "p.exr", "-o", "q.exr"], cwd=self.folder, capture_output=True, text=True,
                              preexec_fn=small_files)
        self.assertEqual(done.returncode, 1)
        self.assertIn("q.exr: ", done.stderr)
        self.assertNotIn(".tmp", done.stderr)
        self.assertEqual(self.files(), ["a.pfm", "p.exr"])


if __name__ == "__main__":
    main()
