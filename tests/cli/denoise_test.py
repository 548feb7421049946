import os
import subprocess

from command_line import BUILD, CommandLineTest, PROGRAM, main

SMALL = ["--resolution", "32x32", "--spp", "4"]


class Denoise(CommandLineTest):
    def test_render_and_denoise_are_the_same_in_one_go_or_two(self):
        self.lambert("render", *SMALL, "--denoise", "-o", "once.pfm")
        self.lambert("render", *SMALL, "--aov", "denoising", "-o", "noisy.exr")
        self.lambert("denoise", "noisy.exr", "-o", "twice.pfm")
        self.assertEqual((self.folder / "once.pfm").read_bytes(), (self.folder / "twice.pfm").read_bytes())
        self.lambert("render", *SMALL, "-o", "noisy.pfm")
        self.assertNotEqual((self.folder / "once.pfm").read_bytes(), (self.folder / "noisy.pfm").read_bytes())

    def test_layers_that_were_asked_for_stay(self):
        info = lambda path: self.lambert("image", "info", path).stdout
        self.lambert("render", *SMALL, "--denoise", "--aov", "albedo", "-o", "albedo.exr")
        self.assertIn("albedo.R", info("albedo.exr"))
        self.assertNotIn("denoising.a.R", info("albedo.exr"))
        self.lambert("render", *SMALL, "--denoise", "--aov", "denoising", "-o", "all.exr", "-o", "once.pfm")
        self.assertIn("denoising.a.R", info("all.exr"))
        self.lambert("denoise", "all.exr", "-o", "again.pfm")
        self.assertEqual((self.folder / "once.pfm").read_bytes(), (self.folder / "again.pfm").read_bytes())

    def test_methods_and_formats(self):
        self.lambert("render", *SMALL, "-o", "noisy.png")
        for method in ("nfor", "nlm", "bilateral"):
            self.lambert("denoise", "noisy.png", "--method", method, "-o", f"{method}.png", "-o", f"{method}.exr")
            self.assertIn(f"{method}.exr", self.files())

    def test_says_what_is_wrong(self):
        self.lambert("render", *SMALL, "-o", "noisy.png")
        said = self.lambert("denoise", "noisy.png", "--method", "nform", "-o", "a.png", status=1).stderr
        self.assertIn("nfor", said)
        said = self.lambert("denoise", "noisy.png", "--oidn-library", "/no/such.so", "--method", "oidn", "-o", "a.png",
                            status=1).stderr
        self.assertIn("/no/such.so", said)
        self.lambert("denoise", "absent.exr", "-o", "a.png", status=1)
        self.lambert("denoise", "noisy.png", status=2)
        self.assertEqual(self.files(), ["noisy.png"])

    def test_open_image_denoise_is_found_by_the_loader(self):
        folder = BUILD / "tests" / "fake_oidn"
        if not (folder / "libOpenImageDenoise.so.2").exists():
            self.skipTest("the stand-in for Open Image Denoise is not built")
        self.lambert("render", *SMALL, "-o", "noisy.exr")
        done = subprocess.run([PROGRAM, "denoise", "noisy.exr", "-o", "clean.exr"], cwd=self.folder, text=True,
                              env={**os.environ, "LD_LIBRARY_PATH": str(folder)}, capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b"libOpenImageDenoise.so.2", (self.folder / "clean.exr").read_bytes())


if __name__ == "__main__":
    main()
