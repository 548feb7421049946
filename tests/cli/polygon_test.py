"""Every verb of `lambert polygon` on input with a known answer, and what it says to wrong input."""
import json
import re
import subprocess
import xml.etree.ElementTree

from command_line import PROGRAM, SOURCE, CommandLineTest, main

CORPUS = SOURCE / "tests" / "corpora" / "polygon"
EXAMPLES = SOURCE / "docs" / "guide" / "polygon"
SQUARE = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n"
SHIFTED = "POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))\n"
NOTCHED = "0 0\n10 0.2\n11 6\n6 2\n1 7\n"


class Polygon(CommandLineTest):
    def polygon(self, *arguments, status=0):
        return self.lambert("polygon", *arguments, status=status)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def facts(self, *arguments, status=0):
        return json.loads(self.polygon(*arguments, "--json", status=status).stdout)

    def area(self, name, *arguments):
        return self.facts("area", name, *arguments)["area"]

    def polygons(self, text):
        """The rings of every polygon of GeoJSON text."""
        rings = []
        for feature in json.loads(text)["features"]:
            g = feature["geometry"]
            if g is not None:
                rings += [g["coordinates"]] if g["type"] == "Polygon" else g["coordinates"]
        return rings


class Queries(Polygon):
    def test_check_names_the_index(self):
        self.assertEqual(self.facts("check", self.write("a.wkt", SQUARE))["ok"], True)
        done = self.polygon("check", EXAMPLES / "faults.geojson", status=1)
        self.assertIn("polygon 0, ring 0: vertices 2 and 3 coincide", done.stdout)
        self.assertIn("polygon 1, ring 0: not closed", done.stdout)
        line = self.write("line.wkt", "LINESTRING (0 0, 1 0, 1 1, 0 1)")
        self.assertEqual(self.facts("check", line, status=1)["paths"][0]["fault"], "not-closed")
        ring = self.write("ring.wkt", "LINESTRING (0 0, 1 0, 1 1, 0 0)")
        self.assertTrue(self.facts("check", ring)["ok"])

    def test_an_open_triangle_is_not_closed(self):
        done = self.polygon("check", self.write("a.wkt", "POLYGON ((0 0, 4 0, 0 4))"), status=1)
        self.assertIn("not closed: vertex 2", done.stdout)

    def test_sizes_far_from_1(self):
        for size in (1e150, 1e-150, 1e200, 1e-300):
            square = self.write("a.wkt", f"POLYGON ((0 0, {4 * size} 0, {4 * size} {4 * size}, 0 {4 * size}, 0 0))")
            self.assertIn("inside", self.polygon("contains", square, "--at", f"{size},{size}").stdout)
            self.assertIn("outside", self.polygon("contains", square, "--at", f"{5 * size},{size}").stdout)
            self.assertIn("simple, convex", self.polygon("classify", square).stdout)
            clipped = self.polygon("clip", square, "--half-plane", f"0,0,{size},{size}", "--to", "geojson").stdout
            self.assertEqual(len(self.polygons(clipped)[0][0]), 4)
            window = f"--window={size},{size},{2 * size},{9 * size}"
            self.assertEqual(len(self.polygons(self.polygon("clip", square, window, "--to", "geojson").stdout)), 1)
            self.assertEqual(self.polygon("fill", square, "--resolution", "4x4").stdout.splitlines()[-1], "16 pixels")
        self.assertAlmostEqual(self.area(self.write("a.wkt", "POLYGON ((0 0, 1e150 0, 1e150 1e150, 0 1e150, 0 0))")) / 1e300, 1)
        large = self.write("a.wkt", "POLYGON ((0 0, 1e200 0, 1e200 1e200, 0 1e200, 0 0))")
        self.assertIn("beyond the range of numbers", self.polygon("area", large, status=1).stderr)
        self.assertIn("beyond the range of numbers", self.polygon("normal", large, status=1).stderr)
        small = self.write("a.wkt", "POLYGON ((0 0, 1e-200 0, 1e-200 1e-200, 0 1e-200, 0 0))")
        self.assertIn("beyond the range of numbers", self.polygon("area", small, status=1).stderr)
        both = self.write("a.wkt", "POLYGON ((0 0, 1e150 0, 1e-150 1e-150, 0 0))")
        self.assertIn("info: a.wkt: beside coordinates of 1e+150", self.polygon("area", both).stderr.replace("1e150", "1e+150"))

    def test_a_bow_tie_has_no_normal(self):
        done = self.polygon("normal", self.write("a.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"), status=1)
        self.assertIn("its signed areas cancel", done.stdout)
        done = self.polygon("normal", self.write("a.wkt", "POLYGON ((0 0, 4 4, 8 8, 0 0))"), status=1)
        self.assertIn("all vertices lie on a line", done.stdout)

    def test_what_a_verb_leaves_out_is_noted(self):
        mixed = self.write("a.wkt", "POLYGON Z ((0 0 1, 4 0 1, 4 4 1, 0 0 1))\nLINESTRING Z (0 0 1, 1 1 1, 2 0 1, 0 0 1)\nMULTIPOINT (1 1, 2 2)\n")
        everything = "1 line, 2 points, third coordinates"
        parts = {"check": "2 points", "classify": "1 line, 2 points", "normal": "1 line, 2 points", "area": everything,
                 "contains --at=1,1": everything, "pick --at=1,1": "2 points, third coordinates", "clip --window=1,1,2,2": everything,
                 "clip --line=0,1,1,1": everything, "clip --half-plane=0,0,1,1 --trace": everything, f"union {mixed}": everything,
                 f"intersect {mixed}": everything, f"difference {mixed}": everything, f"xor {mixed}": everything, "trapezoids": everything,
                 "convex": everything, "triangulate": everything, "strips": everything, "fill": everything,
                 "fill --resolution=4x4": everything, "extrude": everything, "revolve": "2 points, third coordinates", "convert": ""}
        for command, left_out in parts.items():
            with self.subTest(command=command):
                notes = set(self.polygon(*command.split(), mixed).stderr.splitlines())
                self.assertEqual(notes, {f"lambert: info: a.wkt: left out: {left_out}"} if left_out else set())
        self.assertEqual(self.polygon("union", self.write("b.wkt", SQUARE)).stderr, "")

    def test_fill_refuses_what_its_table_cannot_hold(self):
        far = self.write("a.wkt", "POLYGON ((0 0, 2e6 0, 0 4, 0 0))")
        self.assertIn("vertex 1: (2e+06, 0) is beyond", self.polygon("fill", far, status=1).stderr)

    def test_classify_tells_the_classes_apart(self):
        classes = {"0 0, 4 0, 4 4, 0 4": "simple", "0 0, 2 2, 4 0, 4 4, 2 2, 0 4": "vertex-twice", "0 0, 4 4, 4 0, 0 4": "edges-cross",
                   "0 0, 4 0, 4 4, 2 4, 2 0, 1 0, 0 4": "edges-coincide", "0 0, 4 0, 2 0, 2 3": "spike", "0 0, 1 0": "too-few"}
        for vertices, word in classes.items():
            first = vertices.split(",")[0]
            ring = self.facts("classify", self.write("a.wkt", f"POLYGON (({vertices}, {first}))"), status=0 if word == "simple" else 1)
            self.assertEqual(ring["rings"][0]["class"], word)
        bow_tie = self.facts("classify", self.write("a.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"), status=1)["rings"][0]
        self.assertEqual((bow_tie["first"], bow_tie["second"], bow_tie["point"]), (0, 2, [2, 2]))

    def test_classify_knows_convex_and_rings_that_cross(self):
        arrow = self.facts("classify", self.write("a.txt", "0 0\n4 0\n1 1\n0 4\n"))["rings"][0]
        self.assertEqual((arrow["convex"], arrow["reflex"], arrow["orientation"]), (False, [2], "counter-clockwise"))
        crossing = self.write("b.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 5 1, 5 2, 1 2, 1 1))")
        self.assertIn("rings 0 and 1 cross", self.polygon("classify", crossing, status=1).stdout)

    def test_normal(self):
        octant = self.facts("normal", self.write("a.wkt", "POLYGON Z ((1 0 0, 0 1 0, 0 0 1, 1 0 0))"))["rings"][0]
        for n in octant["normal"]:
            self.assertAlmostEqual(n, 3 ** -0.5, places=12)
        self.assertAlmostEqual(octant["area"], 3 ** 0.5 / 2, places=12)
        bent = self.write("b.txt", "0 0 0\n100 0 0\n100 100 0.004\n1 100 0.004\n0 99 0.004\n0 0.04 0.004\n")
        self.assertFalse(self.facts("normal", bent)["rings"][0]["planar"])
        flat = self.write("c.txt", "0 0\n1 1\n2 2\n")
        self.assertIsNone(self.facts("normal", flat, status=1)["rings"][0]["normal"])

    def test_area_by_both_rules(self):
        twice = self.write("a.txt", "0 0\n4 0\n4 4\n0 4\n\n1 1\n2 1\n2 2\n1 2\n")
        self.assertEqual(self.area(twice), 15)
        self.assertEqual(self.area(twice, "--rule", "non-zero"), 16)
        room = self.facts("area", EXAMPLES / "room.geojson")["features"][0]
        self.assertEqual((room["name"], room["regions"], room["holes"]), ("room", 1, 2))
        self.assertAlmostEqual(room["area"], 55.25, places=12)

    def test_contains(self):
        a = self.write("a.txt", "0 0\n10 0\n10 10\n5 3\n0 10\n")
        queries = [(5, 1, "inside"), (5, 6, "outside"), (1, 7, "inside"), (-1, 5, "outside"), (5, 2.9, "inside"), (5, 3, "on"), (0, 0, "on")]
        points = self.facts("contains", a, *[w for x, y, _ in queries for w in ("--at", f"{x},{y}")])["points"]
        self.assertEqual([p["place"] for p in points], [place for _, _, place in queries])
        self.write("q.txt", "".join(f"{x} {y}\n" for x, y, _ in queries))
        self.assertEqual(self.facts("contains", a, "--points", "q.txt")["points"], points)
        self.assertIn("'Bora'", self.polygon("contains", EXAMPLES / "islands.geojson", "--at", "9,5").stdout)

    def test_pick_in_units_and_in_pixels(self):
        a = self.write("a.txt", "line\n0 0\n10 0\n")
        at = [(5, 0.9), (5, 1.5), (-1.5, 0), (-1.5, 1.5), (11, 1.2), (12.5, 0)]
        flags = [w for x, y in at for w in ("--at", f"{x},{y}")]
        points = self.facts("pick", a, "--units", "--radius", 2, "--width", 2, *flags)["points"]
        self.assertEqual([p["picked"] is not None for p in points], [True, False, True, False, True, False])
        field = self.facts("pick", a, "--at", "0,0", "--window", "0,0,10,10", "--viewport", "100x100", "--radius", 8)["field"]
        self.assertAlmostEqual(field["radius"], 0.8, places=12)
        self.assertIn("picks nothing", self.polygon("pick", a, "--at", "5,5").stdout)


class Clipping(Polygon):
    def test_trace_of_the_lecture_notes(self):
        done = self.polygon("clip", EXAMPLES / "seven.txt", "--half-plane", "0,0,1,0", "--trace")
        self.assertTrue(done.stdout.endswith("result: 2 A B 5 C D 1\n"))
        states = re.findall(r"^ +\d  ([a-z ]+?)  ", done.stdout, re.M)
        self.assertEqual(states, ["start", "stay in", "leave", "stay out", "enter", "leave", "stay out", "enter"])

    def test_what_falls_apart_is_several_polygons(self):
        u = self.write("u.txt", "0 0\n6 0\n6 4\n4 4\n4 1\n2 1\n2 4\n0 4\n")
        self.polygon("clip", u, "--half-plane", "0,2,1,2", "-o", "c.wkt")
        features = self.facts("area", "c.wkt")["features"]
        self.assertEqual((features[0]["regions"], features[0]["area"]), (2, 8))

    def test_window_keeps_properties(self):
        done = self.polygon("clip", EXAMPLES / "islands.geojson", "--window=-1,-1,5,5")
        features = json.loads(done.stdout)["features"]
        self.assertEqual([f["properties"]["name"] for f in features], ["Alba", "Bora"])
        self.assertIsNone(features[1]["geometry"])

    def test_line(self):
        done = self.polygon("clip", EXAMPLES / "seven.txt", "--line", "0,0,1,0", "--to", "geojson")
        lines = json.loads(done.stdout)["features"][0]["geometry"]["coordinates"]
        self.assertEqual([[round(x, 6) for x, _ in line] for line in lines], [[0, 2.333333], [3.666667, 6]])

    def test_flags_that_do_not_go_together(self):
        a = self.write("a.wkt", SQUARE)
        self.assertIn("--window", self.polygon("clip", a, status=1).stderr)
        self.assertIn("--line", self.polygon("clip", a, "--line", "0,0,1,1", "--window", "0,0,1,1", status=1).stderr)
        self.assertIn("two different points", self.polygon("clip", a, "--half-plane", "1,1,1,1", status=1).stderr)
        for verb in (["clip"], ["pick", "--at", "0,0"]):
            self.assertIn("x0 <= x1", self.polygon(*verb, a, "--window", "2,0,1,1", status=1).stderr)
        trace = ["clip", a, "--half-plane", "0,0,1,1", "--trace"]
        for more in (["--window", "0,0,1,1"], ["--half-plane", "1,1,0,0"], ["-o", "c.wkt"], ["--svg", "c.svg"], ["--to", "wkt"]):
            self.assertIn("--trace", self.polygon(*trace, *more, status=1).stderr)
        self.assertEqual(self.files(), ["a.wkt"])


class Booleans(Polygon):
    def test_areas(self):
        self.write("a.wkt", SQUARE), self.write("b.wkt", SHIFTED)
        for verb, area in (("union", 28), ("intersect", 4), ("difference", 12), ("xor", 24)):
            done = self.polygon(verb, "a.wkt", "b.wkt", "-o", "r.geojson")
            self.assertEqual(done.stdout.strip(), str(self.folder / "r.geojson"))
            self.assertEqual(self.area("r.geojson"), area, verb)
            self.polygon("classify", "r.geojson")

    def test_several_files_and_one(self):
        self.write("a.wkt", SQUARE), self.write("b.wkt", SHIFTED)
        self.write("c.txt", "3 3\n5 3\n5 5\n3 5\n")
        for verb, area in (("union", 28), ("intersect", 1), ("difference", 12)):
            self.polygon(verb, "a.wkt", "b.wkt", "c.txt", "-o", "r.wkt")
            self.assertEqual(self.area("r.wkt"), area, verb)
        star = self.polygon("union", EXAMPLES / "star.wkt", "--rule", "non-zero", "--to", "geojson").stdout
        self.assertEqual([len(p) for p in self.polygons(star)], [1])
        self.assertEqual(len(self.polygons(self.polygon("union", EXAMPLES / "star.wkt", "--to", "geojson").stdout)), 5)

    def test_nothing_is_a_result(self):
        self.write("a.wkt", SQUARE)
        done = self.polygon("difference", "a.wkt", "a.wkt", "--to", "geojson")
        self.assertIsNone(json.loads(done.stdout)["features"][0]["geometry"])
        self.assertEqual(self.polygon("xor", "a.wkt", "a.wkt").stdout, "GEOMETRYCOLLECTION EMPTY\n")

    def test_a_second_file_is_needed(self):
        for verb in ("intersect", "difference", "xor"):
            self.polygon(verb, self.write("a.wkt", SQUARE), status=2)


class Decomposition(Polygon):
    def pieces(self, *arguments):
        text = self.polygon(*arguments, "--to", "geojson").stdout
        return [rings[0] for rings in self.polygons(text)]

    def signed_area(self, ring):
        return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:])) / 2

    def test_pieces_tile_the_polygon(self):
        notched, room = self.write("n.txt", NOTCHED), EXAMPLES / "room.geojson"
        for name, area in ((notched, 41.9), (room, 55.25)):
            for verb in (["trapezoids"], ["trapezoids", "--tie-break", "rotation", "--seed", 3], ["convex"], ["convex", "--method", "trapezoids"],
                         ["triangulate"], ["triangulate", "--method", "sweep"]):
                pieces = self.pieces(*verb, name)
                self.assertAlmostEqual(sum(map(self.signed_area, pieces)), area, places=9, msg=verb)
                self.assertGreater(min(map(self.signed_area, pieces)), 0)
        self.assertEqual(len(self.pieces("trapezoids", notched)), 5)
        self.assertEqual(len(self.pieces("triangulate", "--method", "ears", notched)), 3)
        self.assertEqual(len(self.pieces("triangulate", room)), 15 - 2 + 2 * 2)

    def test_strips_are_the_triangles(self):
        strips = self.facts("strips", EXAMPLES / "room.geojson")["features"][0]
        self.assertEqual(sum(len(s) - 2 for s in strips["strips"]), 17)
        self.assertEqual(len(strips["vertices"]), 15)

    def test_unknown_methods_name_the_known_ones(self):
        a = self.write("a.wkt", SQUARE)
        for verb, flag, word, known in (("triangulate", "--method", "delauney", "delaunay"), ("convex", "--method", "x", "joined"),
                                        ("trapezoids", "--tie-break", "x", "symbolic"), ("area", "--rule", "evenodd", "even-odd")):
            self.assertIn(known, self.polygon(verb, a, flag, word, status=1).stderr)
        self.assertIn("holes", self.polygon("triangulate", EXAMPLES / "room.geojson", "--method", "ears", status=1).stderr)

    def test_a_mesh_is_a_result(self):
        done = self.polygon("triangulate", EXAMPLES / "room.geojson", "-o", "m.ply", "-o", "m.wkt", "--svg", "m.svg")
        self.assertEqual(done.stdout.split(), [str(self.folder / n) for n in ("m.ply", "m.wkt", "m.svg")])
        self.assertIn("triangles   17\n", self.lambert("info", "m.ply").stdout)

    def test_an_unknown_extension_is_told_the_known_ones_before_anything_is_written(self):
        done = self.polygon("triangulate", EXAMPLES / "room.geojson", "-o", "m.ply", "-o", "m.stl", status=1)
        for known in ("m.stl: unknown extension '.stl'", ".geojson", ".svg", ".ply", ".obj", ".glb"):
            self.assertIn(known, done.stderr)
        self.assertEqual(self.files(), [])
        done = self.polygon("convex", EXAMPLES / "room.geojson", "-o", "m.ply", status=1)
        self.assertIn(".svg", done.stderr)
        self.assertNotIn(".glb", done.stderr)


class Filling(Polygon):
    # rows: PG-34
    def test_span_table_of_the_lecture_notes(self):
        table = self.facts("fill", EXAMPLES / "six.txt")
        self.assertEqual(table["pixels"], 46)
        self.assertEqual([(r["y"], *r["spans"][0]) for r in table["rows"]],
                         [(12, 6, 6), (11, 5, 6), (10, 4, 6), (9, 3, 6), (8, 2, 7), (7, 1, 8), (6, 2, 8), (5, 3, 8), (4, 4, 8), (3, 5, 7),
                          (2, 6, 6)])

    def test_resolution_counts_pixel_centres(self):
        a = self.write("a.wkt", SQUARE)
        self.assertEqual(self.facts("fill", a, "--resolution", "10x10")["pixels"], 100)
        self.assertEqual(self.facts("fill", a, "--resolution", "20x10")["pixels"], 100)
        self.assertEqual(self.polygon("fill", a, "--resolution", "8x8", "-o", "f.png").stdout.strip(), str(self.folder / "f.png"))
        self.assertTrue((self.folder / "f.png").read_bytes().startswith(b"\x89PNG"))
        self.assertIn("--resolution", self.polygon("fill", a, "--resolution", "0x8", status=1).stderr)


class Solids(Polygon):
    def vertices_and_faces(self, text):
        lines = [line.split() for line in text.splitlines()]
        vertices = [tuple(map(float, words[1:])) for words in lines if words[0] == "v"]
        return vertices, [[int(w.split("/")[0]) - 1 for w in words[1:]] for words in lines if words[0] == "f"]

    def volume(self, text):
        vertices, faces = self.vertices_and_faces(text)
        total = 0
        for face in faces:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (vertices[i] for i in face)
            total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
        return total / 6

    def test_extrude(self):
        unit = self.write("a.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")
        text = self.polygon("extrude", unit, "--along", "0,0,3").stdout
        self.assertAlmostEqual(self.volume(text), 3, places=6)
        self.assertEqual(len(set(self.vertices_and_faces(text)[0])), 8)

    def test_revolve(self):
        line = self.write("l.wkt", "LINESTRING (1 0, 1 2)")
        vertices, faces = self.vertices_and_faces(self.polygon("revolve", line, "--steps", 16).stdout)
        self.assertEqual((len({tuple(round(c, 5) for c in v) for v in vertices}), len(faces)), (32, 32))
        tube = self.write("t.txt", "1 0\n2 0\n2 1\n1 1\n")
        self.assertAlmostEqual(self.volume(self.polygon("revolve", tube, "--steps", 360).stdout), 3.14159265 * 3, places=2)

    def test_meshes_are_scenes(self):
        for extension in ("ply", "obj", "glb"):
            self.polygon("extrude", EXAMPLES / "gear.wkt", "-o", f"g.{extension}")
            self.assertRegex(self.lambert("info", f"g.{extension}").stdout, r"triangles +\d{3}\n")
        self.assertIn(".ply", self.polygon("extrude", EXAMPLES / "gear.wkt", "-o", "g.stl", status=1).stderr)

    def test_what_has_no_solid(self):
        a = self.write("a.wkt", SQUARE)
        self.polygon("extrude", a, "--along", "1,0,0", status=1)
        self.polygon("revolve", self.write("b.wkt", "POLYGON ((-1 0, 1 0, 1 1, -1 0))"), status=1)
        self.assertIn("enclose nothing", self.polygon("extrude", self.write("c.txt", "0 0\n1 1\n"), status=1).stderr)


class Files(Polygon):
    def test_round_trip_through_every_format(self):
        sources = [CORPUS / "good-bare.json", *(p for p in sorted(EXAMPLES.iterdir()) if p.suffix in (".geojson", ".wkt", ".txt"))]
        sources = [p for p in sources if p.stem != "faults"]  # its open ring is closed in a vertex list
        self.assertGreater(len(sources), 8)
        for source in sources:
            with self.subTest(source=source.name):
                extensions = ("geojson", "wkt", "txt", "json", "wkt", "geojson")
                previous = source
                for i, extension in enumerate(extensions):
                    self.polygon("convert", previous, "-o", f"{i}.{extension}")
                    previous = f"{i}.{extension}"
                # A vertex list is one feature: the coordinates are compared, not how features group them.
                first, last = (re.findall(r"\[[^\[\]]+\]", (self.folder / f"{i}.geojson").read_text()) for i in (0, 5))
                self.assertEqual(first, last)

    def test_geojson_keeps_members(self):
        written = json.loads(self.polygon("convert", CORPUS / "good.geojson").stdout)
        original = json.loads((CORPUS / "good.geojson").read_text())
        for feature in (written["features"][3], original["features"][3]):
            feature["geometry"] = None  # its two kinds of points become one
        self.assertEqual(written, original)

    def test_standard_input_and_output(self):
        for arguments in ([], ["-"]):
            done = subprocess.run([PROGRAM, "polygon", "area", *arguments], input=SQUARE, capture_output=True, text=True)
            self.assertIn("area 16", done.stdout)
        done = subprocess.run([PROGRAM, "polygon", "union", "-", "-o", "-"], input=SQUARE, capture_output=True, text=True)
        self.assertEqual(done.stdout, SQUARE)

    def test_bad_files_are_refused_with_their_place(self):
        bad = sorted(CORPUS.glob("bad-*"))
        self.assertGreater(len(bad), 30)
        for source in bad:
            for verb in ("area", "convert"):
                with self.subTest(source=source.name, verb=verb):
                    done = self.polygon(verb, source, "-o", "out." + ("json" if verb == "area" else "geojson"), status=1)
                    self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                    self.assertRegex(done.stderr, rf"{re.escape(source.name)}:\d+:\d+: ")
                    self.assertEqual(done.stdout, "")
                    self.assertEqual(self.files(), [])

    def test_errors_name_feature_ring_and_vertex(self):
        self.write("a.wkt", "POINT (1 2)\nPOLYGON ((0 0, 1 0, 0 1, 0 0), (0 0, 1 nan))")
        self.assertIn("a.wkt:2:40: feature 1, ring 1, vertex 1: expected a second number, found 'nan'",
                      self.polygon("area", "a.wkt", status=1).stderr)

    def test_unknown_words(self):
        self.write("a.wkt", SQUARE)
        self.assertIn("did you mean 'union'", self.polygon("uniom", "a.wkt", status=2).stderr)
        self.assertIn(".geojson", self.polygon("union", "a.wkt", "-o", "a.shp", status=1).stderr)
        self.assertIn("vertices", self.polygon("union", "a.wkt", "--to", "shp", status=1).stderr)
        self.assertIn("--at", self.polygon("contains", "a.wkt", "--at", "1;2", status=1).stderr)
        self.assertIn("missing.wkt", self.polygon("area", "missing.wkt", status=1).stderr)
        self.polygon(status=2)
        self.assertEqual(self.files(), ["a.wkt"])

    def test_shells_complete_the_verbs(self):
        self.assertIn("triangulate", self.lambert("completion", "bash").stdout)


class Pictures(Polygon):
    VERBS = [["check"], ["classify"], ["normal"], ["area"], ["contains", "--at", "3,3"], ["pick", "--at", "3,3"], ["clip", "--window", "1,1,9,6"],
             ["clip", "--line", "0,3,1,3"], ["union"], ["trapezoids"], ["convex"], ["triangulate"], ["strips"], ["fill"],
             ["fill", "--resolution", "40x30"], ["convert"]]

    def test_every_verb_draws(self):
        for verb in self.VERBS:
            with self.subTest(verb=verb):
                self.polygon(verb[0], EXAMPLES / "room.geojson", *verb[1:], "--svg", "p.svg", "--png", "p.png")
                root = xml.etree.ElementTree.parse(self.folder / "p.svg").getroot()
                self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
                self.assertGreater(len(root), 10)
                self.assertTrue((self.folder / "p.png").read_bytes().startswith(b"\x89PNG"))

    def test_degenerate_input_is_drawn(self):
        for text in ("POLYGON EMPTY", "POLYGON ((0 0))", "POLYGON ((1e300 1e300, -1e300 1e300, 0 -1e300, 1e300 1e300))",
                     "POLYGON ((1e-300 0, 0 1e-300, 0 0, 1e-300 0))", "POLYGON ((5 5, 5 5, 5 5, 5 5))"):
            self.write("a.wkt", text)
            for verb in (["convert"], ["union"], ["triangulate"], ["area"]):
                if verb == ["area"] and "300" in text:  # no double holds it
                    self.assertIn("beyond the range of numbers", self.polygon(*verb, "a.wkt", status=1).stderr)
                    continue
                with self.subTest(text=text, verb=verb):
                    self.polygon(*verb, "a.wkt", "--svg", "p.svg", "--png", "p.png")
                    xml.etree.ElementTree.parse(self.folder / "p.svg")

    def test_clips_of_any_size_are_drawn(self):
        for size in (1e-300, 1, 1e300):
            triangle = self.write("a.wkt", f"POLYGON (({size} {size}, {-size} {size}, 0 {-size}, {size} {size}))")
            for flag in ("--line", "--half-plane"):
                self.polygon("clip", triangle, f"{flag}={-size},{-size},{size},{size}", "--svg", f"{flag[2:]}.svg")
            marks = [len(xml.etree.ElementTree.parse(self.folder / n).getroot()) for n in ("line.svg", "half-plane.svg")]
            if size == 1e-300:
                expected = marks
            self.assertEqual(marks, expected, size)
            self.assertGreater(min(marks), 20)

    def test_a_picture_is_no_geometry(self):
        done = self.polygon("union", EXAMPLES / "star.wkt", "--svg", "p.svg")
        self.assertTrue(done.stdout.startswith("MULTIPOLYGON"))
        done = self.polygon("union", EXAMPLES / "star.wkt", "-o", "p.svg", "-o", "r.wkt")
        self.assertEqual(done.stdout.split(), [str(self.folder / "r.wkt"), str(self.folder / "p.svg")])


class Guide(CommandLineTest):
    PAGE = SOURCE / "docs" / "guide" / "polygon.md"

    def test_every_command_prints_what_the_page_says(self):
        commands = re.findall(r"^    \$ (.*lambert polygon .*)\n((?:    [^$\n].*\n)*)", self.PAGE.read_text(), re.M)
        self.assertGreater(len(commands), 10)
        for command, printed in commands:
            with self.subTest(command=command):
                done = subprocess.run(command.replace("lambert polygon", f"'{PROGRAM}' polygon", 1), shell=True, cwd=EXAMPLES,
                                      capture_output=True, text=True)
                self.assertEqual(done.stderr + done.stdout, re.sub("^    ", "", printed, flags=re.M))

    def test_the_program_is_the_one_that_is_built(self):
        program = (SOURCE / "tests" / "examples" / "polygon_example.cpp").read_text()
        self.assertIn("```cpp\n" + program + "```", self.PAGE.read_text())

    def test_pictures_are_there(self):
        for picture in re.findall(r"\]\((polygon/[^) ]+)[^)]*\)", self.PAGE.read_text()):
            self.assertTrue((self.PAGE.parent / picture).exists(), picture)


if __name__ == "__main__":
    main()
