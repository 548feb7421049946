#!/usr/bin/env python3
"""Tone operators beside pfstmo on a map of 1920 x 1080: CPU seconds (user and system, all threads), in turn, medians.

    bench/tonemap/run.py LAMBERT [MAP] [--runs N] [--plot FILE.svg]

LAMBERT is the program of a build of the preset bench, which has bench_tonemap too. Without MAP a scene of the repository is rendered; of
a map with negative numbers pfstmo makes NaN and nothing. Both sides are measured twice: the operator alone (ours in memory; pfstmo from a
.pfs file to nowhere, which includes reading and writing its stream), and the whole way from EXR to PNG."""
import argparse
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "bench"))
import svg_plot  # noqa: E402

PAIRS = [("photographic", [], "pfstmo_reinhard02", []), ("photographic-local", [], "pfstmo_reinhard02", ["-s"]),
         ("drago", [], "pfstmo_drago03", []), ("durand", ["spatial=2.0833333"], "pfstmo_durand02", ["-q"]),
         ("fattal", [], "pfstmo_fattal02", []), ("reinhard-devlin", [], "pfstmo_reinhard05", [])]


def cpu(command):
    """CPU seconds of a shell line and all it starts."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, shell=True, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("lambert", type=pathlib.Path)
    parser.add_argument("map", nargs="?")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--plot")
    a = parser.parse_args()
    if not shutil.which("pfstmo_drago03"):
        sys.exit("bench/tonemap: pfstmo is not installed")
    program = a.lambert.resolve()
    bench = program.parents[1] / "bench/tonemap/bench_tonemap"
    with tempfile.TemporaryDirectory() as folder:
        exr, pfs = f"{folder}/map.exr", f"{folder}/map.pfs"
        if a.map:
            shutil.copy(a.map, exr)
        else:
            subprocess.run([program, "render", SOURCE / "scenes/environment/environment.pbrt", "--resolution", "1920x1080", "--spp", "4",
                            "--quiet", "-o", exr], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(f"pfsinexr {exr} > {pfs}", shell=True, check=True, stderr=subprocess.DEVNULL)
        rows = []
        print(f"{'operator':22}{'lambert':>10}{'pfstmo':>10}{'ratio':>8}   {'EXR to PNG':>10}{'pfs':>10}{'ratio':>8}")
        for ours, settings, peer, words in PAIRS:
            alone, theirs, whole, their_whole = [], [], [], []
            sets = " ".join(f"--set {s}" for s in settings)
            for _ in range(a.runs):
                alone.append(float(subprocess.run([bench, exr, ours, *settings], check=True, capture_output=True, text=True).stdout))
                theirs.append(cpu(f"{peer} {' '.join(words)} < {pfs} > /dev/null"))
                whole.append(cpu(f"{program} tonemap {exr} --operator {ours} {sets} -o {folder}/ours.png"))
                their_whole.append(cpu(f"pfsinexr {exr} | {peer} {' '.join(words)} | pfsgamma -g 2.2 | pfsoutimgmagick {folder}/theirs.png"))
            m = [statistics.median(v) for v in (alone, theirs, whole, their_whole)]
            print(f"{ours:22}{m[0]:10.4f}{m[1]:10.4f}{m[1] / m[0]:8.1f}   {m[2]:10.3f}{m[3]:10.3f}{m[3] / m[2]:8.1f}", flush=True)
            rows += [(ours, 1000 * m[0], "lambert"), (" ".join([peer, *words]), 1000 * m[1], "pfstmo")]
        if a.plot:
            pathlib.Path(a.plot).write_text(svg_plot.bars("Tone operators, 1920 x 1080, CPU time", "ms", rows))


if __name__ == "__main__":
    main()
