"""Every verb of `lambert probe`, and what it says to wrong input; layouts against OpenEXR's exrenvmap where it is installed."""
import json
import math
import random
import shutil
import struct
import subprocess

from command_line import SOURCE, CommandLineTest, main

SKY = SOURCE / "scenes" / "environment" / "sky.hdr"


def write_pfm(path, width, height, colour):
    rows = b"".join(struct.pack("<3f", *colour(x, y)) for y in reversed(range(height)) for x in range(width))
    path.write_bytes(b"PF\n%d %d\n-1.0\n" % (width, height) + rows)


def read_pfm(path):
    """(width, height, colours with row 0 at the top)"""
    magic, size, _, data = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    channels = 3 if magic == b"PF" else 1
    numbers = struct.unpack("<%df" % (width * height * channels), data)
    pixels = [numbers[i:i + channels] for i in range(0, len(numbers), channels)]
    return width, height, [p for y in reversed(range(height)) for p in pixels[y * width:(y + 1) * width]]


class Probe(CommandLineTest):
    def probe(self, *arguments, status=0):
        return self.lambert("probe", *arguments, status=status)

    def facts(self, *arguments):
        return json.loads(self.probe(*arguments).stdout)

    def constant(self, name="grey.pfm", value=(1, 2, 0.5)):
        write_pfm(self.folder / name, 64, 32, lambda x, y: value)
        return name

    def size(self, name):
        width, height, _ = read_pfm(self.folder / name)
        return width, height


class Layouts(Probe):
    # rows: IS-19 IS-20 LF-09 LF-13
    def test_every_layout_there_and_back(self):
        self.constant()
        shapes = {"lat-long": (64, 32), "vertical-cross": (48, 64), "horizontal-cross": (64, 48), "vertical-strip": (16, 96),
                  "horizontal-strip": (96, 16), "openexr-cube": (16, 96), "openexr-lat-long": (64, 32)}
        for layout in ["mirror-ball", "angular", "fisheye", "octahedral", "equal-area", "opengl-strip", *shapes]:
            self.probe("convert", "grey.pfm", "--to", layout, "--size", 32 if layout.endswith("lat-long") else 16, "-o", "a.pfm")
            if layout in shapes:
                self.assertEqual(self.size("a.pfm"), shapes[layout])
            if layout != "fisheye":  # half of the sphere
                e = self.facts("irradiance", "a.pfm", "--from", layout, "--normal", "0.1,0.2,-1", "--json")["irradiance"]
                for got, want in zip(e, (1, 2, 0.5)):
                    self.assertAlmostEqual(got / want, math.pi, delta=1e-4 * math.pi, msg=layout)
            self.probe("convert", "a.pfm", "--from", layout, "--to", "lat-long", "--size", 8, "-o", "b.pfm")
            _, _, pixels = read_pfm(self.folder / "b.pfm")
            ahead = pixels[4 * 16 + 8]
            self.assertAlmostEqual(ahead[1], 2, delta=1e-3, msg=layout)

    def test_six_files(self):
        out = self.probe("convert", SKY, "--to", "faces", "--size", 8, "-o", "sky_{}.pfm").stdout.split()
        self.assertEqual(self.files(), sorted(f"sky_{f}.pfm" for f in ("px", "nx", "py", "ny", "pz", "nz")))
        self.assertEqual(len(out), 6)
        self.probe("convert", "sky_{}.pfm", "--to", "lat-long", "-o", "back.pfm")
        self.assertEqual(self.size("back.pfm"), (32, 16))
        self.assertIn("six faces need", self.probe("convert", SKY, "--to", "faces", "-o", "x.pfm", status=1).stderr)
        self.assertIn("one picture", self.probe("convert", SKY, "--to", "angular", "-o", "x{}.pfm", status=1).stderr)

    def test_one_of_six_files_is_wrong(self):
        self.probe("convert", SKY, "--to", "faces", "--size", 8, "-o", "sky_{}.pfm")

        def error(*arguments):
            done = self.probe("convert", *arguments, "--to", "lat-long", "-o", "back.pfm", status=1)
            self.assertEqual(len(done.stderr.splitlines()), 1)
            return done.stderr
        py = self.folder / "sky_py.pfm"
        py.unlink()
        self.assertIn("sky_py.pfm: cannot open: No such file or directory (sky_{}.pfm stands for six faces)", error("sky_{}.pfm"))
        write_pfm(py, 8, 4, lambda x, y: (1, 1, 1))
        self.assertIn("sky_py.pfm: expected a square face, got 8x4", error("sky_{}.pfm"))
        write_pfm(py, 4, 4, lambda x, y: (1, 1, 1))
        self.assertIn("sky_py.pfm: expected 8x8 as in sky_px.pfm, got 4x4", error("sky_{}.pfm"))
        py.write_bytes(b"Pf\n8 8\n-1.0\n" + bytes(256))
        self.assertIn("sky_py.pfm: expected the channels R G B as in sky_px.pfm, got Y", error("sky_{}.pfm"))
        self.assertIn("lat-long is one picture", error("sky_{}.pfm", "--from", "lat-long"))
        self.assertIn("faces are six files", error("sky_px.pfm", "--from", "faces"))

    def test_turns(self):
        write_pfm(self.folder / "dot.pfm", 64, 32, lambda x, y: (1, 1, 1) if x in (31, 32) and y in (15, 16) else (0, 0, 0))
        self.probe("rotate", "dot.pfm", "--yaw", 90, "-o", "left.pfm")
        _, _, pixels = read_pfm(self.folder / "left.pfm")
        brightest = max(range(len(pixels)), key=lambda i: pixels[i][0])
        self.assertIn(brightest % 64, (15, 16))
        self.probe("rotate", "dot.pfm", "--matrix", "0,0,1,0,1,0,-1,0,0", "-o", "same.pfm")
        self.assertEqual((self.folder / "same.pfm").read_bytes(), (self.folder / "left.pfm").read_bytes())

    def test_what_is_not_finite_is_said_and_filled(self):
        write_pfm(self.folder / "holes.pfm", 64, 32, lambda x, y: (math.nan, 1, math.inf) if (x, y) == (10, 10) else (1, 1, 1))
        done = self.probe("convert", "holes.pfm", "--to", "vertical-cross", "-o", "a.pfm")
        self.assertIn("a pixel is not finite", done.stderr)
        _, _, pixels = read_pfm(self.folder / "a.pfm")
        self.assertTrue(all(abs(v) < 1.001 for p in pixels for v in p))
        write_pfm(self.folder / "none.pfm", 4, 2, lambda x, y: (math.nan, 1, 1))
        self.assertIn("none.pfm: expected finite pixels", self.probe("irradiance", "none.pfm", "--normal", "0,1,0", status=1).stderr)

    def test_wrong_input(self):
        (self.folder / "square.pfm").write_bytes(b"Pf\n4 4\n-1.0\n" + bytes(64))
        for arguments, words in (
                (("square.pfm", "--to", "lat-long", "-o", "a.exr"), "say which"),
                ((SKY, "--to", "lat-lon", "-o", "a.exr"), "lat-long"),
                ((SKY, "--from", "mirror-ball", "--to", "lat-long", "-o", "a.exr"), "square"),
                ((SKY, "--to", "lat-long", "--size", 0, "-o", "a.exr"), "--size"),
                ((SKY, "--to", "fisheye", "--to-fov", 500, "-o", "a.exr"), "--to-fov"),
                ((SKY, "--to", "fisheye", "--to-lens", "square", "-o", "a.exr"), "equidistant"),
                ((SKY, "--to", "fisheye", "--to-lens", "orthographic", "--to-fov", 200, "-o", "a.exr"), "180"),
                (("none.exr", "--to", "lat-long", "-o", "a.exr"), "none.exr")):
            with self.subTest(words):
                done = self.probe("convert", *arguments, status=1)
                self.assertIn(words, done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1)
        self.probe("convert", SKY, "-o", "a.exr", status=2)
        self.assertEqual(self.files(), ["square.pfm"])


class Light(Probe):
    # rows: LF-08
    def test_irradiance(self):
        self.constant()
        for method in ("quadrature", "sh"):
            e = self.facts("irradiance", "grey.pfm", "--method", method, "--normal", "1,2,3", "--json")["irradiance"]
            for got, want in zip(e, (1, 2, 0.5)):
                self.assertAlmostEqual(got, want * math.pi, delta=1e-4 * math.pi * want)
            self.probe("irradiance", "grey.pfm", "--method", method, "--size", 4, "-o", "e.pfm")
            for p in read_pfm(self.folder / "e.pfm")[2]:
                self.assertAlmostEqual(p[1], 2, delta=1e-3)
        self.probe("irradiance", "grey.pfm", status=1)

    def test_harmonics(self):
        self.constant()
        c = self.facts("sh", "grey.pfm", "--order", 3, "--json")["coefficients"]
        self.assertEqual(len(c), 16)
        self.assertAlmostEqual(c[0][1], 2 * math.sqrt(4 * math.pi), delta=1e-4)
        self.assertLess(max(abs(v) for row in c[1:] for v in row), 1e-3)
        self.probe("sh", SKY, "--order", 8, "-o", "smooth.pfm")
        self.assertEqual(self.size("smooth.pfm"), (256, 128))
        self.probe("sh", SKY, "--order", 33, status=1)

    # rows: LF-25 LF-27
    def test_sun_and_sky(self):
        self.probe("lights", SKY, "--sky", "rest.pfm", "-o", "lights.json", "--pbrt", "sun.pbrt")
        found = self.json("lights.json")
        sun, = found["lights"]
        want = [v / math.sqrt(0.62**2 + 0.33**2 + 0.71**2) for v in (-0.62, 0.33, -0.71)]
        for got, expected in zip(sun["direction"], want):
            self.assertAlmostEqual(got, expected, delta=0.01)
        e = found["horizontal_irradiance"]
        for whole, sky, light in zip(e["map"], e["sky"], e["lights"]):
            self.assertAlmostEqual((sky + light) / whole, 1, delta=1e-4)
        self.assertLess(max(max(p) for p in read_pfm(self.folder / "rest.pfm")[2]), 5)
        self.assertIn('LightSource "distant"', (self.folder / "sun.pbrt").read_text())

    def test_there_is_no_sun_in_what_is_even_black_or_one_texel(self):
        write_pfm(self.folder / "black.pfm", 64, 32, lambda x, y: (0, 0, 0))
        write_pfm(self.folder / "below.pfm", 64, 32, lambda x, y: (-1, -1, -1))
        write_pfm(self.folder / "one.pfm", 1, 1, lambda x, y: (1, 2, 3))
        for arguments in ((self.constant(),), ("black.pfm",), ("below.pfm",), ("one.pfm", "--from", "lat-long")):
            self.assertEqual(self.facts("lights", *arguments)["lights"], [], arguments)
        e = self.facts("check", "one.pfm", "--from", "angular", "--json")["irradiance_up"]
        for got, want in zip(e, (1, 2, 3)):
            self.assertAlmostEqual(got, want * math.pi, delta=1e-3)

    def test_median_cut(self):
        lights = self.facts("lights", SKY, "--count", 16)["lights"]
        self.assertEqual(len(lights), 16)
        self.probe("lights", SKY, "--count", 16, "--sky", "x.exr", status=1)

    # rows: LF-25
    def test_check(self):
        self.assertGreater(self.facts("check", SKY, "--json")["stops"], 10)
        write_pfm(self.folder / "clipped.pfm", 64, 32,
                  lambda x, y: (100, 100, 100) if 10 <= x < 14 and 4 <= y < 7 else (0.2, 0.3, 0.5) if y < 16 else (0.1, 0.1, 0.1))
        done = self.probe("check", "clipped.pfm", "--json", "--irradiance", "30")
        self.assertIn("clipped", done.stderr)
        facts = json.loads(done.stdout)
        self.assertTrue(facts["clipped"])
        self.assertEqual(facts["plateau"]["texels"], 12)
        self.probe("check", "clipped.pfm", "--irradiance", "30", "--restored", "whole.pfm")
        e = self.facts("irradiance", "whole.pfm", "--normal", "0,1,0", "--json")["irradiance"]
        for v in e:
            self.assertAlmostEqual(v, 30, delta=0.05)
        self.probe("check", "clipped.pfm", "--restored", "whole.pfm", status=1)
        for number in ("nan", "-1", "1,2"):
            self.assertIn("--irradiance", self.probe("check", "clipped.pfm", f"--irradiance={number}", status=1).stderr)


class Balls(Probe):
    # rows: LF-12
    def test_assembly(self):
        self.probe("convert", SKY, "--to", "mirror-ball", "--size", 128, "-o", "a.pfm")
        # A camera at +x: what it sees on the ball is the world turned so that +x comes to +z.
        self.probe("convert", SKY, "--to", "mirror-ball", "--size", 128, "--yaw", -90, "-o", "b.pfm")
        views = self.probe("assemble", "a.pfm", "b.pfm", "--angles", "0,90", "--as-given", "--size", 64, "-o", "all.pfm", "--json").stdout
        self.assertIn('"rotation"', views)
        self.probe("convert", SKY, "--to", "lat-long", "--size", 64, "-o", "truth.pfm")
        got, want = (read_pfm(self.folder / f)[2] for f in ("all.pfm", "truth.pfm"))
        errors = sorted(abs(a[1] - b[1]) / b[1] for a, b in zip(got, want))
        self.assertLess(errors[len(errors) // 2], 0.02)
        self.assertLess(errors[len(errors) * 9 // 10], 0.2)
        self.probe("assemble", "a.pfm", "b.pfm", "--angles", "0", "-o", "x.pfm", status=1)
        self.probe("assemble", "a.pfm", "--angles", "0", "-o", "x.pfm", status=1)
        self.assertIn("--angles", self.probe("assemble", "a.pfm", "b.pfm", "--angles", "0,nan", "-o", "x.pfm", status=1).stderr)
        wrong = self.probe("assemble", "a.pfm", "b.pfm", "--angles", "0,0", "--size", 32, "-o", "x.pfm").stderr
        self.assertIn("b.pfm", wrong)
        self.assertIn("are the angles right?", wrong)

    # rows: LF-09
    def test_find_ball(self):
        def photograph(x, y):
            r = math.hypot(x + 0.5 - 90, y + 0.5 - 70) / 40
            return (1.5 - r, 1.2, 0.6 + 0.5 * r) if r < 1 else (0.1, 0.15, 0.1)
        write_pfm(self.folder / "photo.pfm", 200, 150, photograph)
        found = self.facts("find-ball", "photo.pfm")
        self.assertAlmostEqual(found["centre"][0], 90, delta=0.6)
        self.assertAlmostEqual(found["radius"], 40, delta=0.8)
        self.probe("find-ball", "photo.pfm", "-o", "ball.pfm", "--size", 64)
        self.assertEqual(self.size("ball.pfm"), (64, 64))
        self.constant()
        self.assertIn("no ball found", self.probe("find-ball", "grey.pfm", status=1).stderr)
        # Cut by the frame: found all the same, and said.
        write_pfm(self.folder / "cut.pfm", 200, 150, lambda x, y: photograph(x - 90, y))
        done = self.probe("find-ball", "cut.pfm")
        self.assertRegex(done.stderr, "cut.pfm: 3. % of the ball's outline lies out of the picture")
        self.assertAlmostEqual(json.loads(done.stdout)["centre"][0], 180, delta=0.6)
        generator = random.Random(1)
        write_pfm(self.folder / "noise.pfm", 200, 150, lambda x, y: (generator.random(),) * 3)
        self.assertIn("noise.pfm: no ball found", self.probe("find-ball", "noise.pfm", status=1).stderr)


class OpenExr(Probe):
    # rows: IS-19 IS-20 LF-13
    def test_lat_long_and_cube_as_exrenvmap_makes_them(self):
        if not shutil.which("exrenvmap"):
            self.skipTest("exrenvmap is not installed (Debian's package openexr)")

        def smooth(x, y):
            theta, phi = math.pi * (y + 0.5) / 64, 2 * math.pi * (x + 0.5) / 128
            d = (math.sin(theta) * math.sin(phi), math.cos(theta), math.cos(phi) * math.sin(theta))
            return tuple(1.5 + math.sin(3 * d[i] + 2 * d[i - 1]) for i in range(3))
        write_pfm(self.folder / "a.pfm", 128, 64, smooth)
        self.probe("convert", "a.pfm", "--to", "openexr-lat-long", "--size", 64, "-o", "a.exr")
        # Both read the attribute `envmap`, their own and the other's.
        for kind, flag, layout, size in (("cube", "-c", "openexr-cube", 32), ("map", "-l", "openexr-lat-long", 64)):
            source = "a.exr" if kind == "cube" else "theirs-cube.exr"
            width = size if kind == "cube" else 2 * size
            subprocess.run(["exrenvmap", flag, "-w", str(width), "-f", "1", "9", source, f"theirs-{kind}.exr"],
                           cwd=self.folder, check=True, capture_output=True)
            self.probe("convert", source, "--to", layout, "--size", size, "-o", f"ours-{kind}.pfm")
            self.probe("convert", f"theirs-{kind}.exr", "--to", layout, "--size", size, "-o", "theirs.pfm")
            ours, theirs = (read_pfm(self.folder / f)[2] for f in (f"ours-{kind}.pfm", "theirs.pfm"))
            worst = max(abs(a - b) for p, q in zip(ours, theirs) for a, b in zip(p, q))
            self.assertLess(worst, 0.05, kind)


main()
