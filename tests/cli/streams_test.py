"""Standard input and output in place of files, and several outputs of one command."""
import os
import signal
import struct
import subprocess
import time

from command_line import PROGRAM, CommandLineTest, main

MAGIC = {"exr": b"\x76\x2f\x31\x01", "hdr": b"#?RADIANCE", "pfm": b"PF\n", "png": b"\x89PNG", "jpg": b"\xff\xd8", "tif": b"II*\0",
         "webp": b"RIFF"}
WIDTH, HEIGHT = 16, 8
PFM = b"PF\n%d %d\n-1.0\n" % (WIDTH, HEIGHT) + b"".join(
    struct.pack("<3f", x / WIDTH, y / HEIGHT, 0.25) for y in range(HEIGHT) for x in range(WIDTH))


class StreamsTest(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.temporary = self.folder / "tmp"
        self.temporary.mkdir()
        (self.folder / "a.pfm").write_bytes(PFM)

    def stream(self, *arguments, given=b"", status=0):
        """What a command does whose temporary files would lie in a folder of their own."""
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, input=given, capture_output=True, timeout=120,
                              env=os.environ | {"TMPDIR": str(self.temporary)})
        self.assertEqual(done.returncode, status, f"{arguments}: {done.stderr.decode()}")
        self.assertEqual(list(self.temporary.iterdir()), [])
        return done

    def out(self, *arguments, given=b"", status=0):
        return self.stream(*arguments, given=given, status=status).stdout


class Output(StreamsTest):
    def test_format_stands_in_front(self):
        self.assertTrue(self.out("image", "convert", "a.pfm", "-o", "-").startswith(MAGIC["exr"]))
        for name, magic in MAGIC.items():
            with self.subTest(name):
                self.assertTrue(self.out("image", "convert", "a.pfm", "-o", name + ":-").startswith(magic))
        self.assertEqual(self.out("image", "convert", "a.pfm", "-o", "pfm:-"), PFM)
        done = self.stream("image", "convert", "a.pfm", "-o", "bmp:-", status=1)
        self.assertIn(b"unknown image format '.bmp'", done.stderr)

    def test_words_go_to_standard_error(self):
        done = self.stream("image", "resize", "a.pfm", "--size", "4x2", "-o", "b.png", "-o", "png:-")
        self.assertEqual(done.stdout, (self.folder / "b.png").read_bytes())
        self.assertEqual(done.stderr.decode().strip(), str(self.folder / "b.png"))
        done = self.stream("lab", "nyquist", "--json", "-o", "svg:-")
        self.assertTrue(done.stdout.startswith(b"<svg") and done.stdout.endswith(b"</svg>\n"), done.stdout[:40])
        self.assertIn(b'"facts"', done.stderr)

    def test_polygons_drawings_and_meshes(self):
        square = b"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
        polygon = lambda *arguments: self.out("polygon", *arguments, given=square)
        for file, start in (("-", b"POLYGON"), ("wkt:-", b"POLYGON"), ("geojson:-", b"{"), ("svg:-", b"<svg"), ("png:-", MAGIC["png"])):
            with self.subTest(file):
                self.assertTrue(polygon("union", "-", "-o", file).startswith(start))
        self.assertTrue(polygon("triangulate", "-", "-o", "glb:-").startswith(b"glTF"))
        self.assertTrue(polygon("extrude", "-", "-o", "ply:-").startswith(b"ply\n"))
        self.assertEqual(polygon("extrude", "-", "-o", "obj:-"), polygon("extrude", "-", "-o", "-"))
        done = self.stream("polygon", "fill", "-", "--resolution", "4x4", "-o", "png:-", "-o", "json:-", given=square, status=1)
        self.assertIn(b"standard output takes one file", done.stderr)
        done = self.stream("polygon", "area", "-", "-o", "svg:-", given=square)
        self.assertIn(b"area 16", done.stderr)
        self.assertTrue(done.stdout.endswith(b"</svg>\n"))

    def test_takes_one_file(self):
        done = self.stream("image", "convert", "a.pfm", "-o", "-", "-o", "png:-", status=1)
        self.assertEqual(done.stdout, b"")
        self.assertIn(b"standard output takes one file", done.stderr)

    def test_nothing_comes_when_the_work_fails(self):
        self.assertEqual(self.out("image", "convert", "none.exr", "-o", "-", status=1), b"")
        cut = self.out("image", "convert", "a.pfm", "-o", "exr:-", "--compression", "none")[:-100]
        (self.folder / "cut.exr").write_bytes(cut)
        self.assertEqual(self.out("image", "convert", "cut.exr", "-o", "-", status=1), b"")

    def test_reader_may_go_away(self):
        self.lambert("composite", "colour(0.5,0.25,0.1,1)", "--resolution", "1024x1024", "-o", "big.exr", "--compression", "none",
                     "--depth", "float")
        writer = subprocess.Popen([PROGRAM, "image", "convert", "big.exr", "-o", "exr:-", "--compression", "none"],
                                  cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  env=os.environ | {"TMPDIR": str(self.temporary)})
        writer.stdout.read(10)
        writer.stdout.close()
        self.assertEqual(writer.wait(60), -signal.SIGPIPE)
        writer.stderr.close()
        self.assertEqual(list(self.temporary.iterdir()), [])

    def test_nothing_stays_beside_files_when_the_reader_goes_or_the_terminal_closes(self):
        self.lambert("composite", "colour(0.5,0.25,0.1,1)", "--resolution", "1024x1024", "-o", "big.exr", "--compression", "none",
                     "--depth", "float")
        writer = subprocess.Popen([PROGRAM, "composite", "big.exr over big.exr", "--compression", "none", "-o", "exr:-",
                                   "-o", "b.exr"],
                                  cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        writer.stdout.read(10)
        writer.stdout.close()
        self.assertEqual(writer.wait(60), -signal.SIGPIPE)
        self.assertEqual([f for f in self.files() if f.endswith(".tmp")], [])
        for which in (signal.SIGHUP, signal.SIGINT):
            working = subprocess.Popen([PROGRAM, "composite", "big.exr blur 200 dilate 100 over big.exr", "-o", "b.exr"],
                                       cwd=self.folder, stderr=subprocess.DEVNULL)
            time.sleep(0.4)
            working.send_signal(which)
            self.assertEqual(working.wait(5), 130)
            self.assertEqual([f for f in self.files() if f.endswith(".tmp")], [])

    def test_what_cannot_be_printed_is_an_error(self):
        square = b"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
        (self.folder / "square.wkt").write_bytes(square)
        for words in (["polygon", "area", "square.wkt"], ["polygon", "union", "square.wkt", "-o", "-"], ["image", "info", "a.pfm"]):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([PROGRAM, *words], cwd=self.folder, stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 1, words)
            self.assertIn(b"standard output: cannot write: No space left on device", done.stderr)

    def test_pictures_of_polygons_have_standard_output_alone(self):
        square = b"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
        self.assertTrue(self.out("polygon", "union", "-", "--svg", "svg:-", given=square).endswith(b"</svg>\n"))
        self.assertTrue(self.out("polygon", "area", "-", "--png", "-", given=square).startswith(b"\x89PNG"))
        self.assertEqual(self.out("polygon", "union", "-", "-o", "-", "-o", "svg:-", given=square, status=1), b"")

    def test_a_file_may_be_called_minus(self):
        self.lambert("image", "convert", "a.pfm", "-o", "./png:-.exr")
        self.assertIn("png:-.exr", self.files())

    def test_folder_for_temporary_files_must_take_some(self):
        done = subprocess.run([PROGRAM, "image", "convert", "a.pfm", "-o", "-"], cwd=self.folder, capture_output=True,
                              env=os.environ | {"TMPDIR": str(self.folder / "missing")})
        self.assertEqual((done.returncode, done.stdout), (1, b""))
        self.assertIn(b"standard output: cannot write", done.stderr)


class Input(StreamsTest):
    def test_commands_join(self):
        light = self.out("image", "convert", "a.pfm", "-o", "-")
        self.stream("tonemap", "-", "-o", "b.png", given=light)
        self.lambert("tonemap", "a.pfm", "-o", "c.png")
        self.lambert("compare", "b.png", "c.png", "--fail", "0.002", "--warn", "0.002")
        small = self.out("image", "resize", "-", "--size", "8x", "-o", "pfm:-", given=light)
        self.assertTrue(small.startswith(b"PF\n8 4\n"))
        over = self.out("composite", "- over a.pfm", "-o", "pfm:-", given=light)
        self.assertEqual(len(over), len(PFM))

    def test_kind_is_found_by_the_first_bytes(self):
        for name in MAGIC:
            with self.subTest(name):
                image = self.out("image", "convert", "a.pfm", "-o", name + ":-")
                self.assertIn(b"size      16x8", self.out("image", "info", "-", given=image))
                self.assertIn(b"size      16x8", self.out("info", "-", given=image))

    def test_a_file_behind_the_sign_is_not_copied(self):
        with open(self.folder / "a.pfm", "rb") as given:
            done = subprocess.run([PROGRAM, "image", "convert", "-", "-o", "b.pfm"], cwd=self.folder, stdin=given,
                                  env=os.environ | {"TMPDIR": str(self.folder / "missing")})
        self.assertEqual(done.returncode, 0)
        self.assertEqual((self.folder / "b.pfm").read_bytes(), PFM)

    def test_is_the_same_each_time(self):
        self.stream("compare", "-", "-", given=PFM)
        self.stream("compare", "-", "a.pfm", given=PFM)
        self.stream("composite", "- plus -", "-o", "b.pfm", given=PFM)
        self.lambert("image", "convert", "a.pfm", "--exposure", "1", "-o", "c.pfm")
        self.lambert("compare", "b.pfm", "c.pfm")

    def test_errors_name_it(self):
        for given in (b"", b"no picture"):
            done = self.stream("tonemap", "-", "-o", "b.png", given=given, status=1)
            self.assertIn(b"standard input: is none of the known image formats", done.stderr)
        done = self.stream("image", "convert", "-", "-o", "b.png", given=PFM[:-1], status=1)
        self.assertIn(b"standard input: ", done.stderr)

    def test_messages_and_facts_name_it(self):
        self.assertTrue(self.out("hdr", "range", "-", given=PFM).startswith(b"standard input: "))
        self.assertIn(b"standard input", self.out("image", "info", "-", given=PFM))
        self.assertIn(b"standard input", self.out("info", "-", "--json", given=PFM))
        self.lambert("image", "convert", "a.pfm", "-o", "a.png")
        done = self.stream("hdr", "merge", "-", "a.png", "--stops", "0,1", "-o", "m.exr", given=(self.folder / "a.png").read_bytes(),
                           status=1)
        self.assertIn(b"than standard input though", done.stderr)
        black = b"PF\n8 8\n-1.0\n" + b"\0\0\xc0\x7f" * (3 * 64)
        done = self.stream("probe", "assemble", "-", "-", "--angles", "0,90", "-o", "m.exr", given=black, status=1)
        self.assertIn(b"standard input: expected finite pixels", done.stderr)
        done = self.stream("hdr", "expose", "a.pfm", "-o", "-", status=1)
        self.assertIn(b"standard output: expected .png", done.stderr)

    def test_folder_for_temporary_files(self):
        done = subprocess.run([PROGRAM, "image", "convert", "-", "-o", "b.png"], cwd=self.folder, input=PFM, capture_output=True,
                              env=os.environ | {"TMPDIR": str(self.folder / "missing")})
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"error: standard input: cannot read: no folder for temporary files", done.stderr)

    def test_memory_does_not_grow_with_the_picture(self):
        self.lambert("composite", "colour(0.5,0.25,0.1,1)", "--resolution", "8192x8192", "-o", "big.exr")
        with open(self.folder / "big.exr", "rb") as given, open(self.folder / "out.exr", "wb") as taken:
            cat = subprocess.Popen(["cat"], stdin=given, stdout=subprocess.PIPE)
            lambert = subprocess.Popen([PROGRAM, "image", "convert", "-", "-o", "-"], stdin=cat.stdout, stdout=taken)
            cat.stdout.close()
            _, status, usage = os.wait4(lambert.pid, 0)
            lambert.returncode = os.waitstatus_to_exitcode(status)
            cat.wait()
        self.assertEqual(lambert.returncode, 0)
        floats = 4 * 8192 * 8192 * 4
        self.assertLess(usage.ru_maxrss * 1024, floats / 3)


class SeveralOutputs(StreamsTest):
    def both(self, *arguments):
        printed = self.lambert(*arguments, "-o", "one.exr", "-o", "two.png").stdout
        self.assertEqual([line for line in printed.split("\n") if line.startswith("/")],
                         [str(self.folder / "one.exr"), str(self.folder / "two.png")])
        for name in ("one.exr", "two.png"):
            path = self.folder / name
            self.assertTrue(path.read_bytes().startswith(MAGIC[name[-3:]]))
            path.unlink()

    def test_every_command_that_writes_a_picture(self):
        self.lambert("probe", "convert", "a.pfm", "--to", "mirror-ball", "--size", "32", "-o", "ball.exr")
        self.both("image", "convert", "a.pfm")
        self.both("image", "resize", "a.pfm", "--scale", "2")
        self.both("image", "plane", "--size", "8x8")
        self.both("probe", "convert", "a.pfm", "--to", "octahedral")
        self.both("probe", "rotate", "a.pfm", "--yaw", "30")
        self.both("probe", "irradiance", "a.pfm", "--size", "4")
        self.both("probe", "sh", "a.pfm", "--size", "4")
        self.both("probe", "find-ball", "ball.exr", "--circle", "16,16,16")
        self.both("probe", "assemble", "ball.exr", "ball.exr", "--angles", "0,0", "--size", "8", "--as-given")
        self.both("lab", "comb")
        self.both("tonemap", "a.pfm")
        self.both("denoise", "a.pfm")
        self.both("composite", "a.pfm")

    def test_six_faces_and_one_picture(self):
        self.lambert("probe", "convert", "a.pfm", "--to", "faces", "--size", "4", "-o", "a_{}.png", "-o", "b_{}.exr")
        for face in ("px", "nx", "py", "ny", "pz", "nz"):
            self.assertIn(f"a_{face}.png", self.files())
            self.assertIn(f"b_{face}.exr", self.files())
        done = self.lambert("probe", "convert", "a.pfm", "--to", "faces", "-o", "c_{}.png", "-o", "c.exr", status=1)
        self.assertIn("c.exr: six faces need a name with {} in it", done.stderr)
        self.assertNotIn("c_px.png", self.files())

    def test_merged_maps_and_photographs(self):
        self.lambert("hdr", "expose", "a.pfm", "--bracket", "-2,0,2", "-o", "shot_{}.png", "-o", "shot_{}.tif", "--list", "l.txt")
        self.assertEqual(sum(line.startswith("shot_") for line in (self.folder / "l.txt").read_text().split("\n")), 3)
        self.lambert("hdr", "merge", "l.txt", "--response", "srgb", "-o", "m.exr", "-o", "m.hdr", "-o", "m.pfm")
        self.lambert("compare", "m.exr", "m.pfm", "--fail", "0.01", "--warn", "0.01")
        done = self.lambert("hdr", "merge", "l.txt", "-o", "n.exr", "-o", "n.png", status=1)
        self.assertIn("n.png: radiance does not fit a display format", done.stderr)
        self.assertNotIn("n.exr", self.files())
        self.lambert("hdr", "response", "l.txt", "--response", "srgb", "-o", "r.csv", "-o", "s.csv")
        self.assertEqual((self.folder / "r.csv").read_bytes(), (self.folder / "s.csv").read_bytes())

    def test_one_that_cannot_be_written_is_found_before_the_work(self):
        done = self.lambert("image", "convert", "a.pfm", "-o", "b.png", "-o", "none/b.exr", status=1)
        self.assertIn("none/b.exr: cannot write: there is no folder", done.stderr)
        self.assertNotIn("b.png", self.files())


if __name__ == "__main__":
    main()
