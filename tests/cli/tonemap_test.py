"""`lambert tonemap` as a user types it: operators, stacks, the montage, and what it says to wrong input."""
import json
import os
import shutil
import struct
import subprocess
import unittest
import zlib

from command_line import BUILD, PROGRAM, CommandLineTest, main

OCIO_CONFIG = """ocio_profile_version: 2
roles: {scene_linear: lin, default: lin}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays:
  screen:
    - !<View> {name: half, colorspace: halved}
    - !<View> {name: plain, colorspace: lin}
colorspaces:
  - !<ColorSpace> {name: lin}
  - !<ColorSpace>
    name: halved
    from_scene_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
"""


def pixels(path):
    """The bytes of an 8-bit PNG without interlace, row by row."""
    data = path.read_bytes()
    at, idat = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        idat += body if kind == b"IDAT" else b""
        at += 12 + length
    n = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    raw, stride, rows, last = zlib.decompress(idat), width * n, [], bytes(width * n)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (line[i - n] if i >= n else 0), last[i], (last[i - n] if i >= n else 0)
            guess = left + up - corner
            near = min((left, up, corner), key=lambda v: abs(guess - v))
            line[i] = (line[i] + (0, left, up, (left + up) // 2, near)[kind]) & 255
        rows.append(bytes(line))
        last = bytes(line)
    return width, height, n, rows


class Maps(CommandLineTest):
    def radiance(self, name, rows):
        """A PFM of greys."""
        body = b"".join(struct.pack("<3f", v, v, v) for row in reversed(rows) for v in row)
        (self.folder / name).write_bytes(b"PF\n%d %d\n-1.0\n" % (len(rows[0]), len(rows)) + body)
        return name

    def scene(self):
        return self.radiance("map.pfm", [[0.001 * 1.35 ** ((3 * x + 5 * y) % 48) for x in range(40)] for y in range(30)])

    def operators(self):
        return [o["name"] for o in json.loads(self.lambert("tonemap", "--list", "--json").stdout)]


class Operators(Maps):
    def test_every_operator_writes_a_picture(self):
        scene = self.scene()
        for name in self.operators():
            if name == "ocio":
                continue
            done = self.lambert("tonemap", scene, "--operator", name, "-o", f"{name}.png")
            self.assertEqual(done.stdout.strip(), str((self.folder / f"{name}.png").resolve()))
            width, height, n, rows = pixels(self.folder / f"{name}.png")
            self.assertEqual((width, height, n), (40, 30, 3))
            if name != "darkest-pixels":
                self.assertGreater(len(set(b"".join(rows))), 20, name)

    def test_values(self):
        self.radiance("a.pfm", [[1.0, 0.25]])
        self.lambert("tonemap", "a.pfm", "--operator", "reinhard", "-o", "a.png")
        self.assertEqual(pixels(self.folder / "a.png")[3][0], bytes([188] * 3 + [124] * 3))  # sRGB of 0.5 and 0.2
        self.lambert("tonemap", "a.pfm", "--operator", "reinhard", "--exposure", "-1", "--set", "white=0.5", "-o", "b.png")
        self.assertEqual(pixels(self.folder / "b.png")[3][0][0], 255)
        self.lambert("tonemap", "a.pfm", "--operator", "linear", "--exposure", "auto-1", "--key", "0.5", "--percentiles", "0,100", "-o", "c.png")
        self.assertEqual(pixels(self.folder / "c.png")[3][0], bytes([188] * 3 + [99] * 3))  # 0.5 and 0.125

    def test_montage_has_all_names(self):
        self.lambert("tonemap", self.scene(), "--montage", "--exposure", "auto", "-o", "all.png")
        self.lambert("tonemap", "map.pfm", "--montage", "--operator", "drago,agx", "--columns", 2, "-o", "two.png")
        all_size, two_size = pixels(self.folder / "all.png")[:2], pixels(self.folder / "two.png")[:2]
        self.assertGreater(all_size[0] * all_size[1], 4 * two_size[0] * two_size[1])

    def test_a_stack_of_files(self):
        for i, light in enumerate((0.05, 0.4, 2.0)):
            self.radiance(f"{i}.pfm", [[light * (1 + x) / 20 for x in range(20)] for _ in range(20)])
            self.lambert("tonemap", f"{i}.pfm", "--operator", "linear", "-o", f"{i}.png")
        self.lambert("tonemap", "0.png", "1.png", "2.png", "--operator", "mertens", "-o", "fused.png")
        self.assertEqual(pixels(self.folder / "fused.png")[:2], (20, 20))
        self.radiance("odd.pfm", [[1.0]])
        done = self.lambert("tonemap", "0.png", "odd.pfm", "--operator", "mertens", "-o", "x.png", status=1)
        self.assertIn("the first is 20x20, another 1x1", done.stderr)

    def test_errors(self):
        scene = self.scene()
        before = self.files()
        for words, message in [
                (["--operator", "reinhart"], "reinhard"),
                (["--set", "kee=1"], "unknown setting 'kee'"),
                (["--set", "key=0"], "setting 'key': expected a number above 0, got '0'"),
                (["--set", "key"], "--set: expected key=value, got 'key'"),
                (["--exposure", "bright"], "--exposure: expected a number of stops"),
                (["--exposure", "auto1"], "got 'auto1'"),
                (["--percentiles", "90,10"], "--percentiles: expected LOW,HIGH"),
                (["--channels", "red"], "unknown choice of channels 'red'"),
                (["--operator", "drago,agx"], "several need --montage"),
                (["--montage", "--set", "key=1"], "--set belongs to one operator")]:
            done = self.lambert("tonemap", scene, *words, "-o", "x.png", status=1)
            self.assertIn(message, done.stderr)
        self.assertIn("--output is required", self.lambert("tonemap", scene, status=2).stderr)
        self.assertIn("nothing.exr", self.lambert("tonemap", "nothing.exr", "-o", "x.png", status=1).stderr)
        self.assertIn("stack of exposures", self.lambert("tonemap", scene, scene, "-o", "x.png", status=1).stderr)
        self.lambert("tonemap", scene, "--bogus", status=2)
        self.assertEqual(self.files(), before)

    def test_render_takes_the_operators(self):
        for name in ("drago", "durand", "agx"):
            self.lambert("render", "--resolution", "16x16", "--spp", 1, "--tonemap", name, "--exposure", "auto", "-o", f"{name}.png")


class OpenColorIO(Maps):
    def ocio(self, *words, config=True, status=0):
        (self.folder / "config.ocio").write_text(OCIO_CONFIG)
        environment = {k: v for k, v in os.environ.items() if k != "OCIO"}
        if config:
            environment["OCIO"] = str(self.folder / "config.ocio")
        done = subprocess.run([PROGRAM, "tonemap", "a.pfm", "--operator", "ocio", *words, "-o", "a.png"], cwd=self.folder,
                              env=environment, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def setUp(self):
        super().setUp()
        self.radiance("a.pfm", [[0.8, 0.4]])

    def test_without_a_configuration(self):
        self.assertIn("$OCIO", self.ocio(config=False, status=1).stderr)

    @unittest.skipUnless((BUILD / "bin" / "lambert_ocio.so").exists(), "BUILT WITHOUT OpenColorIO: libopencolorio-dev")
    def test_display_transform(self):
        self.ocio()  # the first view
        self.assertEqual(pixels(self.folder / "a.png")[3][0], bytes([102] * 3 + [51] * 3))
        self.ocio("--set", "display=screen", "--set", "view=plain")
        self.assertEqual(pixels(self.folder / "a.png")[3][0], bytes([204] * 3 + [102] * 3))
        self.assertIn("known: half, plain", self.ocio("--set", "view=quarter", status=1).stderr)
        self.assertIn("known: screen", self.ocio("--set", "display=wall", status=1).stderr)


@unittest.skipUnless(shutil.which("pfstmo_drago03"), "THE PEER IS MISSING: pfstmo is not installed")
class Peer(Maps):
    """The same formulas in pfstmo: its pictures and ours, up to what each calls the average."""

    def peer(self, program):
        subprocess.run(f"pfsinpfm map.pfm | {program} | pfsoutpfm peer.pfm", shell=True, cwd=self.folder, check=True,
                       capture_output=True, timeout=60)
        return self.greens("peer.pfm")

    def greens(self, name):
        head, size, scale, data = (self.folder / name).read_bytes().split(b"\n", 3)
        count = len(data) // 12
        return struct.unpack(("<" if float(scale) < 0 else ">") + f"{3 * count}f", data)[1::3]

    def ours(self, *words):
        self.lambert("tonemap", "map.pfm", *words, "-o", "ours.pfm")
        return self.greens("ours.pfm")

    def compare(self, program, words, tolerance):
        self.scene()
        peer, ours = self.peer(program), self.ours(*words)
        self.assertEqual(len(peer), len(ours))
        for p, o in zip(peer, ours):
            self.assertAlmostEqual(min(max(p, 0), 1), o, delta=tolerance)

    def test_drago(self):
        self.compare("pfstmo_drago03", ["--operator", "drago"], 0.02)

    def test_photographic(self):
        self.compare("pfstmo_reinhard02", ["--operator", "photographic"], 0.02)


if __name__ == "__main__":
    main()
