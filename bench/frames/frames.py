#!/usr/bin/env python3
"""Whole frames: samples per CPU-second, relative error, memory and start-up time of the program.

usage: frames.py LAMBERT [--runs N] [--reference-spp N] [--plots FOLDER]

Every figure is the median of N runs. The relative mean squared error is mean((a - r)² / (r² + 0.01)) over all channels
against a reference of many more samples and another seed.
"""
import argparse
import array
import json
import math
import pathlib
import statistics
import struct
import subprocess
import sys
import tempfile
import time


ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "bench"))
import svg_plot  # noqa: E402

KNOT_SCENE = """Include "{box}"
AttributeBegin
  Translate 278 274 280
  Scale 70 70 70
  Material "diffuse" "rgb reflectance" [ .7 .7 .7 ]
  Shape "plymesh" "string filename" "knot.ply"
AttributeEnd
"""


def torus_knot(path, p=2, q=3, along=2000, around=125):
    """A binary PLY of 2 * along * around triangles, on a torus of radii 2 and 1."""
    points, faces = array.array("f"), bytearray()

    def curve(t):
        r = math.cos(q * t) + 2
        return r * math.cos(p * t), r * math.sin(p * t), -math.sin(q * t)

    for i in range(along):
        t = 2 * math.pi * i / along
        a, b = curve(t), curve(t + 1e-3)
        tangent = [y - x for x, y in zip(a, b)]
        normal = [x + y for x, y in zip(a, b)]
        binormal = (tangent[1] * normal[2] - tangent[2] * normal[1], tangent[2] * normal[0] - tangent[0] * normal[2],
                    tangent[0] * normal[1] - tangent[1] * normal[0])
        normal = (binormal[1] * tangent[2] - binormal[2] * tangent[1], binormal[2] * tangent[0] - binormal[0] * tangent[2],
                  binormal[0] * tangent[1] - binormal[1] * tangent[0])
        lb, ln = math.hypot(*binormal), math.hypot(*normal)
        for j in range(around):
            s, c = math.sin(2 * math.pi * j / around) * 0.45, math.cos(2 * math.pi * j / around) * 0.45
            points.extend(x + c * n / ln + s * d / lb for x, n, d in zip(a, normal, binormal))
    for i in range(along):
        for j in range(around):
            k, l, m, n = (x * around + y for x in (i, (i + 1) % along) for y in (j, (j + 1) % around))
            faces += struct.pack("<B3iB3i", 3, k, m, l, 3, l, m, n)
    header = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
              "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (along * around, 2 * along * around))
    path.write_bytes(header.encode() + points.tobytes() + bytes(faces))


def read_pfm(path):
    with open(path, "rb") as f:
        f.readline()
        width, height = map(int, f.readline().split())
        f.readline()
        pixels = array.array("f")
        pixels.frombytes(f.read(width * height * 12))
    return pixels


def relative_mse(image, reference):
    return math.fsum((a - r) ** 2 / (r * r + 0.01) for a, r in zip(image, reference)) / len(reference)


def measured(command, runs):
    seconds = []
    for _ in range(runs):
        start = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds)


class Bench:
    def __init__(self, lambert, folder, runs):
        self.lambert, self.folder, self.runs = lambert, folder, runs
        self.rates = []

    def render(self, *arguments):
        subprocess.run([self.lambert, "render", *map(str, arguments), "--progress", "none", "--stats", self.folder / "stats.json"],
                       check=True, capture_output=True)
        return json.loads((self.folder / "stats.json").read_text())

    def frame(self, name, *arguments):
        runs = [self.render(*arguments, "-o", self.folder / "frame.pfm") for _ in range(self.runs)]
        rate = statistics.median(r["samples_per_cpu_second"] for r in runs) / 1e6
        rays = statistics.median(r["rays"] / r["render_cpu_seconds"] for r in runs) / 1e6
        memory = max(r["peak_megabytes"] for r in runs)
        self.rates.append((name, rate, "samples"))
        print(f"{name:<28} {rate:6.2f} Msamples per CPU-second, {rays:6.2f} Mrays per CPU-second, peak {memory:.0f} MB", flush=True)

    def reference(self, samples, *arguments):
        self.render(*arguments, "--spp", samples, "--seed", 99, "-o", self.folder / "reference.pfm")
        return read_pfm(self.folder / "reference.pfm")

    def error(self, reference, *arguments):
        errors = []
        for seed in range(self.runs):
            self.render(*arguments, "--seed", seed, "-o", self.folder / "frame.pfm")
            errors.append(relative_mse(read_pfm(self.folder / "frame.pfm"), reference))
        return statistics.median(errors)

    def first_sample(self, name, scene):
        seconds = [self.render(scene, "--spp", 1, "--resolution", "512x512", "-o", self.folder / "frame.pfm")["first_sample_seconds"]
                   for _ in range(self.runs)]
        print(f"{name:<28} first sample after {statistics.median(seconds):.2f} s", flush=True)


def convergence(bench, reference_samples):
    """Relative error against samples, for each sampler."""
    small = ["--resolution", "128x128", "--filter", "box", "--set", "max-depth=8"]
    reference = bench.reference(16 * reference_samples, *small)
    counts = [1, 2, 4, 8, 16, 32, 64, 128, 256]
    return {sampler: [(n, bench.error(reference, *small, "--sampler", sampler, "--spp", n)) for n in counts]
            for sampler in ("independent", "stratified", "halton", "sobol", "blue-noise")}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lambert", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--reference-spp", type=int, default=1024)
    parser.add_argument("--plots", type=pathlib.Path)
    options = parser.parse_args()
    box = ["--resolution", "512x512", "--filter", "box", "--set", "max-depth=8"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bench = Bench(options.lambert.resolve(), folder, options.runs)
        print(f"{'start (--version)':<28} {1000 * measured([bench.lambert, '--version'], 9):.1f} ms", flush=True)
        bench.frame("Cornell box", *box, "--spp", 64)
        reference = bench.reference(options.reference_spp, *box)
        print(f"{'Cornell box':<28} relative MSE at 64 samples {bench.error(reference, *box, '--spp', 64):.5f}", flush=True)
        torus_knot(folder / "knot.ply")
        (folder / "knot.pbrt").write_text(KNOT_SCENE.format(box=ROOT / "scenes/cornell-box/cornell-box.pbrt"))
        bench.frame("with a 500k-triangle knot", folder / "knot.pbrt", *box, "--spp", 64)
        torus_knot(folder / "million.ply", along=4000)
        bench.first_sample("one million triangles (PLY)", folder / "million.ply")
        if options.plots:
            options.plots.mkdir(parents=True, exist_ok=True)
            (options.plots / "frames.svg").write_text(
                svg_plot.bars("Whole frames, 512 x 512, depth 8", "Msamples per CPU-second", bench.rates))
            (options.plots / "convergence.svg").write_text(
                svg_plot.log_lines("Cornell box: relative mean squared error", "samples per pixel", "relative MSE",
                                   convergence(bench, options.reference_spp)))


if __name__ == "__main__":
    main()
