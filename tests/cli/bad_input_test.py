"""Every bad-* file of the corpora is refused: exit 1, one line that names the file, nothing written."""
import resource
import subprocess

from command_line import PROGRAM, SOURCE, CommandLineTest, main

CORPORA = SOURCE / "tests" / "corpora"
SCENES = {".gltf", ".glb", ".pbrt", ".obj", ".ply", ".gz"}
SMALL = ["--quiet", "--resolution", "8x8", "--spp", "1", "--threads", "1"]
MEMORY = 4 << 30


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


class BadInput(CommandLineTest):
    def run_limited(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=30,
                              preexec_fn=limit_memory)

    def expect_refused(self, scene, named, command, options=()):
        done = self.run_limited(command, scene, *options)
        lines = done.stderr.splitlines()
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertTrue(lines[0].startswith("lambert: error: "), lines[0])
        self.assertIn(named, lines[0])
        self.assertEqual(done.stdout, "")
        return lines[0]

    def bad_files(self, folder):
        files = [p for p in sorted((CORPORA / folder).glob("bad-*")) if folder == "image" or p.suffix in SCENES]
        self.assertGreater(len(files), 5)
        return files

    def test_scenes(self):
        for folder in ("gltf", "pbrt", "obj", "ply"):
            for scene in self.bad_files(folder):
                with self.subTest(scene=scene.name):
                    # An .obj's material file is what is wrong with it.
                    name = scene.name if not scene.with_suffix(".mtl").exists() else scene.stem
                    error = self.expect_refused(scene, name, "render", options=[*SMALL, "-o", "out.png"])
                    self.assertEqual(self.files(), [])
                    self.assertEqual(self.expect_refused(scene, name, "info"), error)

    def test_images(self):
        for image in self.bad_files("image"):
            with self.subTest(image=image.name):
                (self.folder / "s.pbrt").write_text(
                    f'WorldBegin LightSource "infinite" "string filename" "{image}" Shape "sphere"')
                self.expect_refused("s.pbrt", image.name, "render", options=[*SMALL, "-o", "out.png"])
                (self.folder / "t.pbrt").write_text(
                    f'WorldBegin Texture "t" "spectrum" "imagemap" "string filename" "{image}"\n'
                    'Material "diffuse" "texture reflectance" "t" Shape "sphere"')
                self.expect_refused("t.pbrt", image.name, "render", options=[*SMALL, "-o", "out.png"])
                self.assertEqual(self.files(), ["s.pbrt", "t.pbrt"])

    def test_seeds_are_good(self):
        for folder in ("gltf", "pbrt", "obj", "ply"):
            for scene in sorted(p for p in (CORPORA / folder).glob("good*") if p.suffix in SCENES):
                with self.subTest(scene=scene.name):
                    done = self.run_limited("render", scene, *SMALL, "-o", "out.png")
                    self.assertEqual(done.returncode, 0, done.stderr)


class Notes(CommandLineTest):
    def test_variants_are_of_gltf_only(self):
        scene = CORPORA / "obj" / "good.obj"
        self.assertIn("--variant is ignored", self.lambert("render", scene, "--variant", "x", "--resolution", "8x8", "--spp", "1",
                                                           "-o", "out.png").stderr)
        self.assertIn("--variant is ignored", self.lambert("info", scene, "--variant", "x").stdout)

    def test_info_lists_notes(self):
        (self.folder / "a.gltf").write_text('{"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_xmp"]}')
        self.assertRegex(self.lambert("info", "a.gltf").stdout, "note .*KHR_xmp is ignored")


if __name__ == "__main__":
    main()
