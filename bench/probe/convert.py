#!/usr/bin/env python3
"""usage: convert.py LAMBERT [--rounds N]: CPU seconds (user + system) of whole commands, medians of rounds taken in turn.

Converts a 4096x2048 lat-long map to a cube of 1024x1024 faces and back, beside OpenEXR's exrenvmap (with its default of 5x5 samples, and
with 2x2) where that is installed, and measures the other verbs."""
import argparse
import pathlib
import resource
import shutil
import statistics
import subprocess
import tempfile


def seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("lambert")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    lambert = str(pathlib.Path(options.lambert).resolve())
    sky = pathlib.Path(__file__).resolve().parents[2] / "scenes/environment/sky.hdr"
    with tempfile.TemporaryDirectory() as folder:
        def probe(*arguments):
            return [lambert, "probe", *map(str, arguments)]
        for extension in ("pfm", "exr"):
            subprocess.run(probe("convert", sky, "--to", "lat-long", "--size", 2048, "-o", "map." + extension), cwd=folder, check=True,
                           capture_output=True)
        subprocess.run(probe("convert", "map.pfm", "--to", "vertical-strip", "--size", 1024, "-o", "cube.pfm"), cwd=folder, check=True,
                       capture_output=True)
        commands = {
            "read and write the map (PFM)": probe("rotate", "map.pfm", "-o", "same.pfm"),
            "map to cube 1024 (PFM)": probe("convert", "map.pfm", "--to", "vertical-strip", "--size", 1024, "-o", "out.pfm"),
            "cube to map (PFM)": probe("convert", "cube.pfm", "--to", "lat-long", "--size", 2048, "-o", "out.pfm"),
            "map to 256x128 (PFM)": probe("convert", "map.pfm", "--to", "lat-long", "--size", 128, "-o", "out.pfm"),
            "map to cube 1024 (EXR)": probe("convert", "map.exr", "--to", "openexr-cube", "--size", 1024, "-o", "out.exr"),
            "irradiance, one normal": probe("irradiance", "map.pfm", "--normal", "0,1,0"),
            "irradiance, 128x64 map": probe("irradiance", "map.pfm", "--size", 64, "-o", "out.pfm"),
            "harmonics, order 2": probe("sh", "map.pfm", "--order", 2),
            "sun and sky": probe("lights", "map.pfm", "--sky", "out.pfm"),
            "64 median-cut lights": probe("lights", "map.pfm", "--count", 64),
        }
        if shutil.which("exrenvmap"):
            for samples in (2, 5):
                commands[f"exrenvmap, map to cube 1024, {samples}x{samples}"] = [
                    "exrenvmap", "-c", "-li", "-w", "1024", "-f", "1", str(samples), "map.exr", "peer.exr"]
        times = {name: [] for name in commands}
        for _ in range(options.rounds):
            for name, command in commands.items():
                times[name].append(seconds(command, folder))
        for name, values in times.items():
            print(f"{name:40} {statistics.median(values):6.2f} s")


main()
