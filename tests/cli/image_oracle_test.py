"""Agreement of `lambert image convert` with OpenImageIO's oiiotool, where both do the same thing."""
import shutil
import struct
import subprocess
import sys
import unittest

from command_line import CommandLineTest, main

OIIOTOOL = shutil.which("oiiotool")
WIDTH, HEIGHT = 41, 23


def pattern():
    """Smooth and rough, beyond 1, all exact in half floats."""
    return [(x / 32, y / 16, ((x * 7 + y * 13) % 64) / 64) for y in range(HEIGHT) for x in range(WIDTH)]


@unittest.skipUnless(OIIOTOOL, "needs oiiotool (Debian: openimageio-tools)")
class Agreement(CommandLineTest):
    def setUp(self):
        super().setUp()
        rows = [pattern()[y * WIDTH:(y + 1) * WIDTH] for y in range(HEIGHT)]
        (self.folder / "a.pfm").write_bytes(b"PF\n%d %d\n-1\n" % (WIDTH, HEIGHT) +
                                            b"".join(struct.pack("<3f", *p) for row in reversed(rows) for p in row))

    def oiio(self, *arguments):
        done = subprocess.run([OIIOTOOL, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, f"oiiotool {arguments}\n{done.stdout}{done.stderr}")
        return done.stdout

    def to_pfm(self, target, *arguments):
        """oiiotool writes no PFM: what it makes goes through a plain float TIFF, which test_the_way_back holds to be exact."""
        self.oiio(*arguments, "--compression", "none", "-o", target + ".tif")
        self.ours(target + ".tif", target + ".pfm")

    def values(self, name):
        data = (self.folder / name).read_bytes()
        magic, size, scale, body = data.split(b"\n", 3)
        width, height = map(int, size.split())
        count = {b"PF": 3, b"Pf": 1}[magic]
        order = "<" if float(scale) < 0 else ">"
        rows = [struct.unpack_from(f"{order}{width * count}f", body, 4 * width * count * y) for y in range(height)]
        return [v for row in reversed(rows) for v in row]

    def assert_agree(self, a, b, absolute, relative=0.0):
        ours, theirs = self.values(a), self.values(b)
        self.assertEqual(len(ours), len(theirs))
        for o, t in zip(ours, theirs):
            self.assertLessEqual(abs(o - t), absolute + relative * abs(t))

    def ours(self, source, target, *arguments):
        self.lambert("image", "convert", source, "-o", target, *arguments)

    def test_the_way_back(self):
        self.to_pfm("back", "a.pfm", "-d", "float")
        self.assert_agree("back.pfm", "a.pfm", 0)

    # Linear formats: what either writes, both read as the same numbers.
    def test_radiance_formats_both_ways(self):
        # oiiotool cuts RGBE mantissas where Lambert rounds them: a step of 1/128 of the largest.
        for name, depth, relative, absolute in (("b.exr", "half", 0, 0), ("b.exr", "float", 0, 0), ("b.tif", "float", 0, 0),
                                                ("b.hdr", "auto", 0, 1.3 * 2 / 128)):
            with self.subTest(name=name, depth=depth):
                self.ours("a.pfm", name, "--depth", depth)
                self.to_pfm("theirs", name, "-d", "float")
                self.ours(name, "ours.pfm")
                self.assert_agree("ours.pfm", "theirs.pfm", 0, 1e-6)
                kind = [] if name == "b.hdr" else ["-d", depth]
                self.oiio("a.pfm", *kind, "-o", name)
                self.to_pfm("theirs", name, "-d", "float")
                self.ours(name, "ours.pfm")
                self.assert_agree("ours.pfm", "theirs.pfm", 0, 1e-6)
                self.assert_agree("ours.pfm", "a.pfm", absolute, relative)

    def test_lossless_compressions(self):
        for compression in ("none", "rle", "zips", "zip", "piz", "pxr24"):
            with self.subTest(compression):
                self.ours("a.pfm", "ours.exr", "--compression", compression)
                self.assertIn(compression, self.oiio("--info", "-v", "ours.exr"))
                self.to_pfm("theirs", "ours.exr", "-d", "float")
                self.assert_agree("a.pfm", "theirs.pfm", 0)
                self.oiio("a.pfm", "-d", "half", "--compression", compression, "-o", "theirs.exr")
                self.ours("theirs.exr", "ours.pfm")
                self.assert_agree("ours.pfm", "a.pfm", 0)

    # Display formats: the same codes to within one, of which sRGB's steepest is 12.92 times as large in light.
    def test_display_formats_both_ways(self):
        for name, bits in (("b.png", 8), ("b.png", 16), ("b.tif", 8), ("b.tif", 16)):
            with self.subTest(name=name, bits=bits):
                step = 2.3 / (2**bits - 1)
                self.ours("a.pfm", "ours-" + name, "--depth", bits)
                self.oiio("a.pfm", "--colorconvert", "linear", "sRGB", "-d", f"uint{bits}", "-o", name)
                self.to_pfm("codes-ours", "ours-" + name, "-d", "float")
                self.to_pfm("codes-theirs", name, "-d", "float")
                self.assert_agree("codes-ours.pfm", "codes-theirs.pfm", 1.01 / (2**bits - 1))
                self.ours(name, "ours.pfm")
                self.to_pfm("theirs", name, "-d", "float", "--colorconvert", "sRGB", "linear")
                self.assert_agree("ours.pfm", "theirs.pfm", step * 1e-3 + 1e-5)

    def test_windows_alpha_and_crop(self):
        self.oiio("a.pfm", "--ch", "R,G,B,A=0.5", "--origin", "-5+7", "--fullsize", "50x30+0+0", "-d", "half", "-o", "w.exr")
        self.ours("w.exr", "ours.exr")
        self.assertIn("pixel data origin: x=-5, y=7", self.oiio("--info", "-v", "ours.exr"))
        self.ours("w.exr", "shown.exr", "--crop-to", "display")
        self.to_pfm("theirs", "w.exr", "--croptofull", "--ch", "R,G,B", "-d", "float")
        self.ours("shown.exr", "ours.pfm")
        self.assert_agree("ours.pfm", "theirs.pfm", 0)

    def test_tiles_mip_maps_and_parts(self):
        self.oiio("a.pfm", "-d", "half", "--tile", 16, 16, "-o", "tiled.exr")
        self.oiio("a.pfm", "-d", "float", "--tile", 16, 16, "--planarconfig", "separate", "-o", "tiled.tif")
        self.oiio("a.pfm", "-d", "half", "-otex:wrap=clamp:resize=0", "mip.exr")
        for name in ("tiled.exr", "tiled.tif", "mip.exr"):
            with self.subTest(name):
                self.ours(name, "ours.pfm")
                self.assert_agree("ours.pfm", "a.pfm", 0)
        self.oiio("a.pfm", "--attrib", "oiio:subimagename", "rgba", "a.pfm", "--mulc", "2", "--attrib", "oiio:subimagename", "diffuse",
                  "--siappend", "-d", "half", "-o", "parts.exr")
        self.ours("parts.exr", "ours.pfm")
        self.assertIn("its 2 parts become layers", self.lambert("image", "convert", "parts.exr", "-o", "one.exr").stderr)
        self.assert_agree("ours.pfm", "a.pfm", 0)
        self.ours("parts.exr", "ours.pfm", "--layer", "diffuse", "--channels", "R,G,B", "--exposure", "-1")
        self.assert_agree("ours.pfm", "a.pfm", 0)

    def test_attributes(self):
        self.oiio("a.pfm", "--attrib:type=rational", "FramesPerSecond", "24000/1001", "--attrib:type=timecode", "smpte:TimeCode",
                  "01:02:03:04", "--attrib:type=float", "shutter", "0.25", "--attrib", "Artist", "someone", "-d", "half", "-o", "t.exr")
        self.ours("t.exr", "ours.exr")
        said = self.oiio("--info", "-v", "ours.exr")
        for part in ("01:02:03:04", "24000/1001", "shutter: 0.25", "someone"):
            self.assertIn(part, said)
        self.assertIn("01:02:03:04", self.lambert("image", "info", "ours.exr").stdout)


if __name__ == "__main__":
    if not OIIOTOOL:
        print("SKIPPED: image_oracle_test needs oiiotool (Debian: openimageio-tools)", file=sys.stderr)
    main()
