#!/usr/bin/env python3
"""`over` of two 3840 x 2160 float pictures beside OpenImageIO, in turn, medians: the whole command from EXR files with ZIP to one, and
the operation alone on images in memory (there without oiiotool, which keeps its inputs in a cache of tiles).

usage: bench/composite/over.py BUILD [--plot FILE.svg] [--rounds N]

BUILD has bin/lambert and bench/composite/bench_composite. OpenImageIO's operation needs Python's module, and is left out without it."""
import argparse
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import svg_plot  # noqa: E402

try:
    import OpenImageIO
except ImportError:
    OpenImageIO = None

CORNERS = (".1,.2,.8,1", ".9,.5,.1,1", "0,.6,.2,.3", ".5,.5,.9,0"), (".7,.2,.3,1", ".1,.5,.6,1", ".4,.3,.2,1", ".5,.2,.1,1")
PLACES = "topleft", "topright", "bottomleft", "bottomright"


def seconds(command, folder):
    """CPU seconds, and those by the clock, of a program."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, time.perf_counter() - start


def our_operation(bench, folder):
    lines = subprocess.run([bench, "3", "a.exr over b.exr", "a.exr", "b.exr"], cwd=folder, check=True, capture_output=True, text=True).stdout
    return [tuple(map(float, line.split())) for line in lines.splitlines()]


def their_operation(folder):
    a, b = (OpenImageIO.ImageBuf(f"{folder}/{name}.exr") for name in "ab")
    for image in (a, b):
        image.read(force=True, convert="float")
    times = []
    for _ in range(3):
        cpu, start = time.process_time(), time.perf_counter()
        OpenImageIO.ImageBufAlgo.over(a, b)
        times.append((time.process_time() - cpu, time.perf_counter() - start))
    return times


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--plot")
    parser.add_argument("--rounds", type=int, default=5)
    a = parser.parse_args()
    lambert, bench = a.build.resolve() / "bin/lambert", a.build.resolve() / "bench/composite/bench_composite"
    with tempfile.TemporaryDirectory() as folder:
        for name, corners in zip("ab", CORNERS):
            fill = "fill:" + ":".join(f"{place}={c}" for place, c in zip(PLACES, corners))
            subprocess.run(["oiiotool", "--pattern", fill, "3840x2160", "4", "--ch", "R,G,B,A", "-d", "float", "--compression", "zip", "-o",
                            f"{name}.exr"], cwd=folder, check=True)
        ours = [lambert, "composite", "a.exr over b.exr", "--depth", "float", "--quiet", "-o", "ours.exr"]
        theirs = ["oiiotool", "a.exr", "b.exr", "--over", "-d", "float", "--compression", "zip", "-o", "theirs.exr"]
        times = {"lambert composite": [], "oiiotool --over": [], "composite() in memory": [], "ImageBufAlgo.over in memory": []}
        for _ in range(a.rounds):
            times["lambert composite"].append(seconds(ours, folder))
            times["oiiotool --over"].append(seconds(theirs, folder))
            times["composite() in memory"] += our_operation(bench, folder)
            if OpenImageIO:
                times["ImageBufAlgo.over in memory"] += their_operation(folder)
    rows = []
    for name, pairs in times.items():
        if pairs:
            cpu, clock = (statistics.median(t) for t in zip(*pairs))
            print(f"{name:30} {cpu:6.3f} CPU s {clock:7.3f} s by the clock")
            rows.append((name, cpu, "OpenImageIO" if name.startswith(("oiio", "Image")) else "lambert"))
    if a.plot:
        pathlib.Path(a.plot).write_text(svg_plot.bars("over of two pictures of 3840 x 2160 floats", "CPU s", rows))


if __name__ == "__main__":
    main()
