"""`over` of two 3840x2160 float pictures as a command, beside oiiotool; CPU seconds, in turn, medians of several.

usage: bench/composite/over.py LAMBERT [OUT.svg]"""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
import svg_plot

CORNERS = (".1,.2,.8,1", ".9,.5,.1,1", "0,.6,.2,.3", ".5,.5,.9,0"), (".7,.2,.3,1", ".1,.5,.6,1", ".4,.3,.2,1", ".5,.2,.1,1")


def seconds(command, folder):
    before = os.times()
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def main():
    lambert = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        for name, corners in zip("ab", CORNERS):
            fill = "fill:" + ":".join(f"{place}={c}" for place, c in zip(("topleft", "topright", "bottomleft", "bottomright"), corners))
            subprocess.run(["oiiotool", "--pattern", fill, "3840x2160", "4", "--ch", "R,G,B,A", "-d", "float", "--compression", "zip", "-o",
                            f"{name}.exr"], cwd=folder, check=True)
        commands = {"lambert composite": [lambert, "composite", "a.exr over b.exr", "--depth", "float", "--quiet", "-o", "ours.exr"],
                    "oiiotool --over": ["oiiotool", "a.exr", "b.exr", "--over", "-d", "float", "--compression", "zip", "-o", "theirs.exr"]}
        times = {name: [] for name in commands}
        for _ in range(5):
            for name, command in commands.items():
                times[name].append(seconds(command, folder))
    rows = [(name, statistics.median(t), name) for name, t in times.items()]
    for name, median, _ in rows:
        print(f"{name}: {median:.2f} CPU-seconds")
    if len(sys.argv) > 2:
        pathlib.Path(sys.argv[2]).write_text(svg_plot.bars("over of two 3840x2160 float EXR files, the whole command", "CPU s", rows))


main()
