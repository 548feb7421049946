#!/usr/bin/env python3
"""Draws the times of bench_booleans against size, one plot a family, the slower of intersection and union.

usage: plot.py TIMES.tsv FOLDER
"""
import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
import svg_plot  # noqa: E402

TITLES = {"stars": "Booleans of two stars of random radii", "blobs": "Booleans of two smooth outlines",
          "combs": "Booleans of two combs", "squares": "Booleans of two grids of squares",
          "coasts": "Booleans of two fractal outlines", "land": "Booleans of the world's land with itself moved"}


def main():
    times, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    curves = {}
    for row in csv.DictReader(times.open(), delimiter="\t"):
        points = curves.setdefault(row["family"], {}).setdefault(row["library"], {})
        edges, milliseconds = int(row["edges"]), 1000 * float(row["seconds"])
        points[edges] = max(points.get(edges, 0), milliseconds)
    folder.mkdir(parents=True, exist_ok=True)
    for family, libraries in curves.items():
        if max(map(len, libraries.values())) < 2:
            continue
        lines = {library: sorted(points.items()) for library, points in libraries.items()}
        (folder / f"booleans-{family}.svg").write_text(
            svg_plot.log_lines(TITLES.get(family, family), "edges of both operands", "milliseconds", lines))


if __name__ == "__main__":
    main()
