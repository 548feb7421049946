"""`lambert image convert` and `info` on files with known content, and what they say to wrong input."""
import json
import struct

from command_line import SOURCE, CommandLineTest, main

CORPUS = SOURCE / "tests" / "corpora" / "image"
WIDTH, HEIGHT = 5, 3
VALUES = [(0.125 * x, 0.25 * y, 0.5) for y in range(HEIGHT) for x in range(WIDTH)]


def pfm(values=VALUES):
    rows = [values[y * WIDTH:(y + 1) * WIDTH] for y in range(HEIGHT)]
    return b"PF\n%d %d\n-1\n" % (WIDTH, HEIGHT) + b"".join(struct.pack("<3f", *p) for row in reversed(rows) for p in row)


class ImageTest(CommandLineTest):
    def setUp(self):
        super().setUp()
        (self.folder / "a.pfm").write_bytes(pfm())

    def image(self, *arguments, status=0):
        return self.lambert("image", *arguments, status=status)

    def convert(self, source, target, *arguments):
        self.image("convert", source, "-o", target, *arguments)
        return self.facts(target)

    def facts(self, name):
        return json.loads(self.image("info", name, "--json").stdout)

    def channels(self, facts):
        return {c["name"]: c for c in facts["channels"]}

    def pixels(self, name):
        """What a PFM file holds, rows from the top."""
        data = (self.folder / name).read_bytes()
        magic, size, _, body = data.split(b"\n", 3)
        width, height = map(int, size.split())
        count = {b"PF": 3, b"Pf": 1}[magic]
        rows = [struct.unpack_from(f"<{width * count}f", body, 4 * width * count * y) for y in range(height)]
        return [row[count * x:count * x + count] for row in reversed(rows) for x in range(width)]


class Info(ImageTest):
    def test_says_what_there_is(self):
        facts = self.facts("a.pfm")
        self.assertEqual((facts["width"], facts["height"]), (WIDTH, HEIGHT))
        self.assertEqual(facts["data_window"], {"x": 0, "y": 0, "width": WIDTH, "height": HEIGHT})
        self.assertEqual(facts["channels"], [
            {"name": "R", "min": 0, "max": 0.5, "mean": 0.25, "nan": 0, "infinite": 0},
            {"name": "G", "min": 0, "max": 0.5, "mean": 0.25, "nan": 0, "infinite": 0},
            {"name": "B", "min": 0.5, "max": 0.5, "mean": 0.5, "nan": 0, "infinite": 0}])
        text = self.image("info", "a.pfm").stdout
        self.assertIn("channel   R, 0 to 0.5, mean 0.25", text)
        self.assertEqual(self.lambert("info", "a.pfm").stdout, text)
        self.assertEqual(json.loads(self.lambert("info", "a.pfm", "--json").stdout), facts)

    def test_counts_what_is_not_finite(self):
        strange = [(float("nan"), float("inf"), 1)] + VALUES[1:]
        (self.folder / "b.pfm").write_bytes(pfm(strange))
        c = self.channels(self.facts("b.pfm"))
        self.assertEqual((c["R"]["nan"], c["R"]["infinite"], c["G"]["nan"], c["G"]["infinite"]), (1, 0, 0, 1))
        self.assertEqual(c["R"]["max"], 0.5)

    def test_reads_or_refuses_the_corpus(self):
        for path in sorted(CORPUS.iterdir()):
            good = path.name.startswith("good") or path.stem in ("bad-inf", "bad-nan")
            with self.subTest(path.name):
                done = self.image("info", path, status=0 if good else 1)
                if not good:
                    self.assertRegex(done.stderr, path.name + ": .")


class Convert(ImageTest):
    def test_every_format_and_back(self):
        for name in ("b.exr", "b.hdr", "b.pic", "b.pfm", "b.png", "b.tif", "b.webp"):
            with self.subTest(name):
                self.convert("a.pfm", name)
                self.convert(name, "c.pfm")
                for got, wanted in zip(self.pixels("c.pfm"), VALUES):
                    for g, w in zip(got, wanted):
                        self.assertAlmostEqual(g, w, delta=4e-3)

    def test_depths(self):
        for name, depth, bound in (("b.exr", "float", 0), ("b.tif", "float", 0), ("b.exr", "half", 2e-4), ("b.png", "16", 2e-5),
                                   ("b.tif", "16", 2e-5), ("b.tif", "8", 4e-3), ("b.pfm", "float", 0)):
            with self.subTest(name + depth):
                self.convert("a.pfm", name, "--depth", depth)
                self.convert(name, "c.pfm")
                for got, wanted in zip(self.pixels("c.pfm"), VALUES):
                    for g, w in zip(got, wanted):
                        self.assertAlmostEqual(g, w, delta=bound)

    def test_channels_layers_and_exposure(self):
        self.convert("a.pfm", "b.exr", "--channels", "sun.R=R,sun.G=G,sun.B=B,A=B", "--depth", "float")
        self.assertEqual(list(self.channels(self.facts("b.exr"))), ["A", "sun.B", "sun.G", "sun.R"])
        c = self.channels(self.convert("b.exr", "c.exr", "--exposure", "2"))
        self.assertEqual((c["sun.B"]["max"], c["A"]["max"]), (2, 0.5))
        c = self.channels(self.convert("b.exr", "c.exr", "--layer", "sun", "--channels", "G,R"))
        self.assertEqual(sorted(c), ["G", "R"])
        done = self.image("convert", "b.exr", "-o", "d.exr", "--layer", "sum", status=1)
        self.assertIn("b.exr: has no layer 'sum'", done.stderr)
        self.assertIn("sun", done.stderr)
        done = self.image("convert", "a.pfm", "-o", "d.exr", "--channels", "Q", status=1)
        self.assertIn("no channel 'Q'", done.stderr)
        self.assertNotIn("d.exr", self.files())

    def test_compressions_and_quality(self):
        for compression in ("none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"):
            c = self.channels(self.convert("a.pfm", "b.exr", "--compression", compression))
            self.assertAlmostEqual(c["B"]["mean"], 0.5, delta=0.01)
        for name in ("b.jpg", "b.webp"):
            self.convert("a.pfm", name, "--quality", "100")
            fine = (self.folder / name).stat().st_size
            self.convert("a.pfm", name, "--quality", "1")
            self.assertLess((self.folder / name).stat().st_size, fine)

    def test_windows(self):
        path = SOURCE / ".." / "shared" / "data" / "compositing" / "openexr-images" / "DisplayWindow" / "t08.exr"
        if not path.exists():
            self.skipTest(f"needs {path}")
        whole = self.facts(path)
        self.assertEqual(whole["data_window"], {"x": 30, "y": 40, "width": 400, "height": 300})
        self.assertEqual(whole["display_window"], {"x": 0, "y": 0, "width": 501, "height": 401})
        kept = self.convert(path, "a.exr")
        self.assertEqual((kept["data_window"], kept["display_window"]), (whole["data_window"], whole["display_window"]))
        shown = self.convert(path, "b.exr", "--crop-to", "display")
        self.assertEqual((shown["data_window"], shown["display_window"]), (whole["display_window"], whole["display_window"]))
        data = self.convert(path, "c.exr", "--crop-to", "data")
        self.assertEqual((data["data_window"], data["display_window"]), (whole["data_window"], whole["data_window"]))
        png = self.convert(path, "d.png")
        self.assertEqual((png["width"], png["height"]), (501, 401))
        self.assertEqual(self.convert(path, "e.png", "--crop-to", "data")["width"], 400)

    def test_one_pixel_grey_and_alpha_alone(self):
        self.convert("a.pfm", "y.exr", "--channels", "Y=R,A=B")
        self.assertEqual([c["name"] for c in self.convert("y.exr", "y.png")["channels"]], ["Y", "A"])
        self.convert("a.pfm", "z.exr", "--channels", "Z=R")
        for name in ("z.png", "z.jpg", "z.webp", "z.pfm", "z.hdr", "z.tif"):
            self.convert("z.exr", name)

    def test_wrong_words(self):
        for arguments, status in ((("convert", "a.pfm"), 2), (("info",), 2),
                                  (("convert", "a.pfm", "-o", "b.exr", "--depth", "9"), 1),
                                  (("convert", "a.pfm", "-o", "b.jpg", "--quality", "0"), 1)):
            self.image(*arguments, status=status)
        for target, depth, part in (("b.png", "half", "stores 8 bits or 16 bits, not half floats"), ("b.hdr", "float", "b.hdr"),
                                    ("b.exr", "8", "half floats or floats"), ("b.bmp", "auto", "unknown image format")):
            done = self.image("convert", "a.pfm", "-o", target, "--depth", depth, status=1)
            self.assertIn(part, done.stderr)
        self.assertIn("none.exr", self.image("info", "none.exr", status=1).stderr)
        self.assertEqual(self.files(), ["a.pfm"])


if __name__ == "__main__":
    main()
