#!/usr/bin/env python3
"""CPU seconds (user + system) of whole `lambert probe` commands on a lat-long map of 4096x2048, and of OpenEXR's exrenvmap, with its
default of 5x5 samples and with 2x2; medians of rounds taken in turn on the same files.

usage: convert.py LAMBERT [--rounds N] [--plot FOLDER]
"""
import argparse
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))
import svg_plot  # noqa: E402


def seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("lambert", type=pathlib.Path)
    arguments.add_argument("--rounds", type=int, default=5)
    arguments.add_argument("--plot", type=pathlib.Path)
    a = arguments.parse_args()
    lambert = str(a.lambert.resolve())

    def probe(*words):
        return [lambert, "probe", *map(str, words)]

    def exrenvmap(*words):
        return ["exrenvmap", *map(str, words)]

    cube = ("-c", "-w", 1024, "-f", 1)
    commands = {
        "read and write the map, PFM": probe("rotate", "map.pfm", "-o", "out.pfm"),
        "map to cube 1024, PFM": probe("convert", "map.pfm", "--to", "vertical-strip", "--size", 1024, "-o", "out.pfm"),
        "cube to map, PFM": probe("convert", "cube.pfm", "--to", "lat-long", "--size", 2048, "-o", "out.pfm"),
        "map to 256x128, PFM": probe("convert", "map.pfm", "--to", "lat-long", "--size", 128, "-o", "out.pfm"),
        "map to mirror ball 1024, PFM": probe("convert", "map.pfm", "--to", "mirror-ball", "--size", 1024, "-o", "out.pfm"),
        "lambert, map to cube, EXR": probe("convert", "map.exr", "--to", "openexr-cube", "--size", 1024, "-o", "out.exr"),
        "exrenvmap, 2x2 samples": exrenvmap(*cube, 2, "map.exr", "peer.exr"),
        "exrenvmap, 5x5 (its default)": exrenvmap(*cube, 5, "map.exr", "peer.exr"),
        "lambert, cube to map, EXR": probe("convert", "cube.exr", "--to", "openexr-lat-long", "--size", 2048, "-o", "out.exr"),
        "exrenvmap, cube to map, 2x2": exrenvmap("-l", "-w", 4096, "-f", 1, 2, "cube.exr", "peer.exr"),
        "irradiance of one normal": probe("irradiance", "map.pfm", "--normal", "0,1,0"),
        "diffuse map of 128x64": probe("irradiance", "map.pfm", "--size", 64, "-o", "out.pfm"),
        "nine harmonics": probe("sh", "map.pfm", "--order", 2),
        "sun and sky": probe("lights", "map.pfm", "--sky", "out.pfm"),
        "64 median-cut lights": probe("lights", "map.pfm", "--count", 64),
    }
    with tempfile.TemporaryDirectory() as folder:
        for made in (probe("convert", ROOT / "scenes/environment/sky.hdr", "--to", "lat-long", "--size", 2048, "-o", "map.pfm"),
                     probe("convert", "map.pfm", "--to", "openexr-lat-long", "--size", 2048, "-o", "map.exr"),
                     probe("convert", "map.pfm", "--to", "vertical-strip", "--size", 1024, "-o", "cube.pfm"),
                     probe("convert", "map.pfm", "--to", "openexr-cube", "--size", 1024, "-o", "cube.exr")):
            subprocess.run(made, cwd=folder, check=True, capture_output=True)
        times = {name: [] for name in commands}
        for _ in range(a.rounds):
            for name, command in commands.items():
                times[name].append(seconds(command, folder))
    medians = {name: statistics.median(values) for name, values in times.items()}
    for name, median in medians.items():
        print(f"{name:32} {median:6.2f} s   ({min(times[name]):.2f} to {max(times[name]):.2f})")
    if a.plot:
        a.plot.mkdir(parents=True, exist_ok=True)
        rows = [(name, median, name.split(",")[0]) for name, median in medians.items() if name.startswith(("lambert", "exrenvmap"))]
        (a.plot / "probe-convert.svg").write_text(svg_plot.bars("4096x2048 lat-long and cube of 1024, EXR to EXR: CPU time", "s", rows))


if __name__ == "__main__":
    main()
