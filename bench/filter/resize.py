#!/usr/bin/env python3
"""CPU seconds of `lambert image resize` and `blur` beside oiiotool's, in turn, on one 2048 x 1080 image of floats; both write halves.

usage: resize.py LAMBERT [--plot FILE.svg] [--rounds N]    medians of N (3) rounds, with the reading and
writing of files, which the line "copy" has alone
"""
import argparse
import array
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import svg_plot

WIDTH, HEIGHT = 2048, 1080


def cpu_seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("lambert")
    parser.add_argument("--plot")
    parser.add_argument("--rounds", type=int, default=3)
    args = parser.parse_args()
    lambert = str(pathlib.Path(args.lambert).resolve())
    small, large = "512x270", "3072x1620"
    cases = {}
    for theirs, ours in (("box", "box"), ("triangle", "triangle"), ("lanczos3", "lanczos"), ("blackman-harris", "blackman-harris")):
        for size, word in ((small, "÷4"), (large, "×1.5")):
            cases[f"{ours} {word}"] = (
                [lambert, "image", "resize", "in.pfm", "--size", size, "--filter", ours, "-o", "out.exr"],
                ["oiiotool", "in.pfm", f"--resize:filter={theirs}", size, "-d", "half", "-o", "out.exr"])
    cases["gaussian blur σ = 2"] = ([lambert, "image", "blur", "in.pfm", "--sigma", "2", "-o", "out.exr"],
                                    ["oiiotool", "in.pfm", "--blur:kernel=gaussian", "8x8", "-d", "half", "-o", "out.exr"])
    cases["copy"] = ([lambert, "image", "blur", "in.pfm", "--filter", "box", "--radius", "0", "-o", "out.exr"],
                     ["oiiotool", "in.pfm", "-d", "half", "-o", "out.exr"])
    times = {name: ([], []) for name in cases}
    with tempfile.TemporaryDirectory() as folder:
        values = array.array("f", [i * 7919 % 10007 / 10007 for i in range(3 * WIDTH * HEIGHT)])
        (pathlib.Path(folder) / "in.pfm").write_bytes(f"PF\n{WIDTH} {HEIGHT}\n-1.0\n".encode() + values.tobytes())
        for _ in range(args.rounds):
            for name, commands in cases.items():
                for command, list_of in zip(commands, times[name]):
                    list_of.append(cpu_seconds(command, folder))
    rows = []
    for name, (ours, theirs) in times.items():
        a, b = statistics.median(ours), statistics.median(theirs)
        print(f"{name:24} lambert {a:7.3f} s   oiiotool {b:7.3f} s   {b / a:5.1f} times")
        rows += [(name, a, "lambert"), ("oiiotool", b, "oiiotool")]
    if args.plot:
        pathlib.Path(args.plot).write_text(svg_plot.bars(f"{WIDTH} x {HEIGHT} floats, with reading and writing", "CPU s", rows))


if __name__ == "__main__":
    main()
