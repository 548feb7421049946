#!/usr/bin/env python3
"""CPU and wall time of `lambert hdr merge` and of pfstools' pipeline on five photographs of 2048x1365, as PNG and as JPEG,
response recovered and all merged, in turn on the same files; medians.

usage: merge.py LAMBERT MAP [--turns N] [--plot FOLDER]: MAP is a radiance map, as of
  lambert render scenes/instances/instances.pbrt --resolution 2048x1365 --spp 4 -o map.exr
"""
import argparse
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
import svg_plot  # noqa: E402

EXPOSE = "--bracket -6..2:2 --full-well 20000 --read-noise 5 -o shot_{}."


def seconds(command, folder):
    """CPU and wall time."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(["bash", "-c", "set -o pipefail; " + command], cwd=folder, check=True, capture_output=True)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("lambert", type=pathlib.Path)
    arguments.add_argument("map", type=pathlib.Path)
    arguments.add_argument("--turns", type=int, default=5)
    arguments.add_argument("--plot", type=pathlib.Path)
    a = arguments.parse_args()
    lambert, rows = a.lambert.resolve(), []
    with tempfile.TemporaryDirectory() as folder:
        for kind in ("png", "jpg"):
            subprocess.run([lambert, "hdr", "expose", a.map.resolve(), *(EXPOSE + kind).split()], cwd=folder, check=True,
                           capture_output=True)
            with open(f"{folder}/{kind}.hdrgen", "w") as script:
                for i in range(5):
                    script.write(f"{folder}/shot_{i:02}.{kind} {2.0 ** (6 - 2 * i)} 1 100 0\n")
            commands = {
                "lambert, response and merge": f"{lambert} hdr merge {kind}.hdrgen -q --align none --ghosts off -o l.exr",
                "lambert, aligned, no ghosts": f"{lambert} hdr merge {kind}.hdrgen -q -o d.exr",
                "pfstools, Mitsunaga-Nayar": f"pfsinhdrgen {kind}.hdrgen | pfshdrcalibrate -c mitsunaga | pfsout m.exr",
                "pfstools, Robertson": f"pfsinhdrgen {kind}.hdrgen | pfshdrcalibrate -c robertson | pfsout p.exr",
            }
            times = {name: [] for name in commands}
            for _ in range(a.turns):
                for name, command in commands.items():
                    times[name].append(seconds(command, folder))
            first = None
            for name, pairs in times.items():
                cpu, wall = (statistics.median(column) for column in zip(*pairs))
                first = first or (cpu, wall)
                print(f"{kind}  {name:28}  CPU {cpu:6.2f} s ({cpu / first[0]:5.1f} x)   wall {wall:6.2f} s ({wall / first[1]:5.1f} x)")
                rows.append((f"{kind}: {name}", cpu, name.split(",")[0]))
    if a.plot:
        a.plot.mkdir(parents=True, exist_ok=True)
        (a.plot / "hdr-merge.svg").write_text(svg_plot.bars("Five photographs of 2048x1365 to a radiance map: CPU time", "s", rows))


if __name__ == "__main__":
    main()
