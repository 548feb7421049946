"""`lambert hdr`: photographs of a map that lambert renders, merged back, and what is said to stacks that cannot be."""
import json
import math
import struct
import zlib

from command_line import SOURCE, CommandLineTest, main


def png_with_exif(path, time, f_number, iso, out):
    """The PNG with this eXIf chunk, and no other, before its data."""
    data = path.read_bytes()
    if (at := data.find(b"eXIf")) > 0:
        length, = struct.unpack(">I", data[at - 4:at])
        data = data[:at - 4] + data[at + 8 + length:]
    rational = lambda v: struct.pack("<II", round(v * 10000), 10000)
    tags = [(0x829A, 5, 1, rational(time)), (0x829D, 5, 1, rational(f_number)), (0x8827, 3, 1, struct.pack("<HH", iso, 0))]
    start = 8 + 2 + 12 + 4  # header, then a directory of one entry
    exif_dir = struct.pack("<H", len(tags))
    blobs, at = b"", start + 2 + 12 * len(tags) + 4
    for tag, kind, count, value in tags:
        if len(value) > 4:
            exif_dir += struct.pack("<HHII", tag, kind, count, at + len(blobs))
            blobs += value
        else:
            exif_dir += struct.pack("<HHI", tag, kind, count) + value
    tiff = b"II*\0" + struct.pack("<I", 8) + struct.pack("<H", 1) + struct.pack("<HHII", 0x8769, 4, 1, start) + b"\0" * 4
    tiff += exif_dir + b"\0" * 4 + blobs
    chunk = struct.pack(">I", len(tiff)) + b"eXIf" + tiff + struct.pack(">I", zlib.crc32(b"eXIf" + tiff))
    end_of_header = 8 + 25
    out.write_bytes(data[:end_of_header] + chunk + data[end_of_header:])


class Hdr(CommandLineTest):
    def hdr(self, *arguments, status=0):
        return self.lambert("hdr", *arguments, status=status)

    def facts(self, *arguments):
        return json.loads(self.hdr("merge", *arguments, "--json", "--quiet").stdout)

    def setUp(self):
        super().setUp()
        self.lambert("render", SOURCE / "scenes/instances/instances.pbrt", "--resolution", "160x120", "--spp", "16", "--quiet",
                     "-o", "map.exr")

    def expose(self, *arguments):
        self.hdr("expose", "map.exr", "--bracket", "-6..2:2", "-o", "shot_{}.png", "--list", "shots.txt", *arguments)

    def test_merge_takes_back_what_expose_wrote(self):
        self.expose()
        self.assertEqual(self.files(), ["map.exr"] + [f"shot_{i:02}.png" for i in range(5)] + ["shots.txt"])
        facts = self.facts("shots.txt", "-o", "back.exr", "--response-out", "r.csv", "--plot", "r.svg")
        self.assertEqual(facts["written"], ["back.exr", "r.csv", "r.svg"])
        self.assertIn("exposure (1 saturates)", (self.folder / "r.svg").read_text())
        self.assertEqual(facts["response"], "srgb")
        self.assertEqual([p["exposure"] for p in facts["photographs"]], [2.0**s for s in (-6, -4, -2, 0, 2)])
        before = json.loads(self.hdr("range", "map.exr", "--json").stdout)
        after = json.loads(self.hdr("range", "back.exr", "--json").stdout)
        self.assertAlmostEqual(math.log(after["max"] / before["max"]), 0, delta=0.02)
        # A known response from a file, the list by flag, and files in any order: the same picture.
        self.hdr("merge", "shot_03.png", "shot_00.png", "shot_01.png", "shot_04.png", "shot_02.png", "--list", "shots.txt", "--response",
                 "r.csv", "-o", "again.pfm")

    def test_exposures_come_from_exif_flags_and_stops(self):
        self.expose()
        names = []
        for i, stops in enumerate((-6, -4, -2, 0, 2)):
            # 2^stops by time and, of the last one, by speed
            time, iso = (2.0**stops, 100) if stops < 2 else (1, 400)
            png_with_exif(self.folder / f"shot_{i:02}.png", time, 1, iso, self.folder / f"exif_{i}.png")
            names.append(f"exif_{i}.png")
        exif = self.facts(*names, "-o", "a.exr")
        self.assertAlmostEqual(exif["photographs"][0]["exposure"], 2.0**-6, delta=1e-4)
        self.assertAlmostEqual(exif["photographs"][4]["exposure"], 4)
        shots = [f"shot_{i:02}.png" for i in range(5)]
        self.hdr("merge", *shots, "--times", "1/64,1/16,1/4,1,4", "-o", "b.exr", "--quiet")
        self.hdr("merge", *shots, "--stops", "-6,-4,-2,0,2", "-o", "c.exr", "--quiet")
        self.assertEqual((self.folder / "b.exr").read_bytes(), (self.folder / "c.exr").read_bytes())

    def test_photographs_know_their_times(self):
        for kind in ("png", "jpg"):
            self.hdr("expose", "map.exr", "--bracket", "-6..2:2", "--time", "1/3", "-o", f"known_{{}}.{kind}")
            facts = self.facts(*(f"known_{i:02}.{kind}" for i in range(5)), "-o", "a.exr")
            for photograph, stops in zip(facts["photographs"], (-6, -4, -2, 0, 2)):
                self.assertAlmostEqual(photograph["exposure"] / 2.0**stops, 1 / 3, delta=1e-5)

    def test_refusals_have_reasons(self):
        self.expose()
        two = ["shot_01.png", "shot_02.png"]
        self.lambert("image", "convert", two[0], "-o", "bare_0.png")
        self.lambert("image", "convert", two[1], "-o", "bare_1.png")
        for arguments, words in (
            (["bare_0.png", "bare_1.png"], "exposure time is not known"),
            ([*two, "--times", "1,1"], "same exposure"),
            ([*two, "--times", "4,1"], "contradict"),
            ([*two, "--times", "1"], "1 exposures for 2 photographs"),
            ([*two, "--times", "1,x"], "'x'"),
            (["shot_01.png", "map.exr", "--times", "1,2"], "holds radiance already"),
            (["shot_01.png", "missing.png", "--times", "1,2"], "missing.png"),
            (["--times", "1,2"], "2 exposures for 0"),
            ([*two, "--times", "1,4", "--response", "sgrb"], "srgb"),
            ([*two, "--times", "1,4", "--align", "no"], "alignment"),
            ([*two, "--times", "1,4", "--reference", "2"], "--reference"),
        ):
            done = self.hdr("merge", *arguments, "-o", "x.exr", status=1)
            self.assertIn(words, done.stderr)
        self.assertIn("display format", self.hdr("merge", *two, "--times", "1,4", "-o", "x.png", status=1).stderr)
        self.hdr("merge", *two, status=2)
        self.hdr("merge", *two, "-o", "x.exr", "--compression", "gzip", status=1)
        self.hdr("expose", "map.exr", "--bracket", "4..1", "-o", "a_{}.png", status=1)
        self.hdr("expose", "map.exr", "--bracket", "-1..1", "-o", "a.png", status=1)
        self.assertNotIn("x.exr", self.files())
        self.hdr("expose", "map.exr", "--time", "1000000", "-o", "s0.png")
        self.hdr("expose", "map.exr", "--time", "2000000", "-o", "s1.png")
        done = self.hdr("merge", "s0.png", "s1.png", "--times", "1,2", "-o", "x.exr", status=1)
        self.assertIn("cannot be recovered", done.stderr)

    def test_stacks_from_the_hand_are_put_right(self):
        self.expose("--shake", "6", "--full-well", "20000", "--read-noise", "5", "--seed", "3")
        moved = self.facts("shots.txt", "-o", "a.exr", "--align", "shift")
        self.assertTrue(any(p["shift"] != [0, 0] for p in moved["photographs"]))
        still = self.facts("shots.txt", "-o", "b.exr", "--align", "none", "--ghosts", "off")
        self.assertTrue(all(p["shift"] == [0, 0] for p in still["photographs"]))
        self.assertEqual(still["ghost_pixels"], 0)

    def test_response_prints_and_writes_tables(self):
        self.expose("--response", "film")
        table = self.hdr("response", "shots.txt").stdout.splitlines()
        self.assertEqual(table[1], "0,0,0,0")
        self.assertEqual([float(v) for v in table[-1].split(",")], [1, 1, 1, 1])
        for method in ("debevec", "robertson", "mitsunaga"):
            self.hdr("response", "shots.txt", "--response", method, "--by", "code", "-o", f"{method}.csv")
            self.assertEqual(len((self.folder / f"{method}.csv").read_text().splitlines()), 257)

    def test_sixteen_bits_go_through_tiff_and_png(self):
        self.hdr("expose", "map.exr", "--bracket", "-4,0", "-o", "t_{}.tif", "--bits", "16", "--list", "t.txt", "--response", "linear")
        facts = self.facts("t.txt", "-o", "a.exr", "--response", "linear")
        self.assertEqual(facts["bits"], 16)
        self.hdr("expose", "map.exr", "--bracket", "-4,0", "-o", "t_{}.png", "--bits", "16", "--response", "linear")
        self.assertEqual(self.facts("t_00.png", "t_01.png", "-o", "b.exr", "--response", "linear")["bits"], 16)


if __name__ == "__main__":
    main()
