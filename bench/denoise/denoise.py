"""Error of the denoisers against references, and their time for a megapixel: prints tables, and with --plot FILE.svg draws the error
over samples.

    python3 bench/denoise/denoise.py build/release/bin/lambert [--spp 4,16,64] [--reference 128] [--seed 7] [--plot error.svg]

A reference r has noise too. With two independent ones, the mean of (x - r1)(x - r2) is the mean squared error of x without it.
"""
import argparse
import array
import operator
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import svg_plot
import boxes

METHODS = ("nfor", "nlm", "bilateral")
OTHERS = {"depth of field": "depth-of-field", "textures": "textures", "materials": "materials", "caustic": "caustic"}


def pixels(path):
    data = path.read_bytes().split(b"\n", 3)
    width, height = map(int, data[1].split())
    values = array.array("f")
    values.frombytes(data[3][:width * height * 12])
    return values


def errors(image, truths, scale):
    """MSE, and relMSE: over the squared mean of a pixel's channels plus 0.01."""
    products = [(x - r) * (x - s) for x, r, s in zip(image, *truths)]
    return sum(products) / len(products), sum(map(operator.mul, products, scale)) / len(products)


def relative_scale(truths):
    levels = [sum(values) / 6 for values in zip(*(t[c::3] for t in truths for c in range(3)))]
    return [1 / (level * level + 0.01) for level in levels for _ in range(3)]


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = program, pathlib.Path(folder)

    def run(self, *words):
        """Its CPU seconds."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([self.program, *map(str, words)], check=True, stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    def errors_of(self, scene, words, options):
        """(samples, method) to (MSE, relMSE)."""
        shot = ["render", *words, "--resolution", options.size, "--quiet"]
        truths = []
        for seed in (options.seed + 1, options.seed + 2):
            self.run(*shot, "--spp", options.reference, "--seed", seed, "-o", self.folder / "truth.pfm")
            truths.append(pixels(self.folder / "truth.pfm"))
        scale, found = relative_scale(truths), {}
        for spp in map(int, options.spp.split(",")):
            self.run(*shot, "--spp", spp, "--seed", options.seed, "--aov", "denoising",
                     "-o", self.folder / "n.exr", "-o", self.folder / "noisy.pfm")
            for method in ("noisy", *METHODS):
                if method != "noisy":
                    self.run("denoise", self.folder / "n.exr", "--method", method, "-o", self.folder / f"{method}.pfm")
                mse, rel = found[spp, method] = errors(pixels(self.folder / f"{method}.pfm"), truths, scale)
                less, rel_less = found[spp, "noisy"][0] / mse, found[spp, "noisy"][1] / rel
                print(f"{scene:14} {spp:5} {method:10} {mse:10.3g} {less:6.1f}x {rel:10.3g} {rel_less:6.1f}x", flush=True)
        return found

    def time_of_a_megapixel(self, scene):
        picture = self.folder / "large.exr"
        self.run("render", scene, "--resolution", "1024x1024", "--spp", 4, "--aov", "denoising", "--quiet", "-o", picture)
        seconds = {method: [] for method in ("convert", *METHODS)}
        for _ in range(3):
            seconds["convert"].append(self.run("image", "convert", picture, "-o", self.folder / "large.pfm"))
            for method in METHODS:
                seconds[method].append(self.run("denoise", picture, "--method", method, "-o", self.folder / "large.pfm"))
        for method, values in seconds.items():
            print(f"1024x1024 {method:10} {statistics.median(values):6.2f} CPU s", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--spp", default="4,16,64")
    parser.add_argument("--reference", type=int, default=128)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--size", default="192x192")
    parser.add_argument("--plot")
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(o.program, folder)
        scenes = {"box": [], **{k: [v] for k, v in boxes.write(folder).items()},
                  **{k: [boxes.SCENES / v / f"{v}.pbrt"] for k, v in OTHERS.items()}}
        curves = {m: [] for m in ("noisy", *METHODS)}
        print(f"{'scene':14} {'spp':>5} {'method':10} {'MSE':>10} {'less':>7} {'relMSE':>10} {'less':>7}")
        for scene, words in scenes.items():
            for (spp, method), (mse, _) in bench.errors_of(scene, words, o).items():
                if scene == "box":
                    curves[method].append((spp, mse))
        bench.time_of_a_megapixel(scenes["textured"][0])
        if o.plot:
            pathlib.Path(o.plot).write_text(svg_plot.log_lines("The Cornell box: mean squared error", "samples per pixel", "MSE", curves))


main()
