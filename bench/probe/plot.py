#!/usr/bin/env python3
"""Draws what bench_irradiance prints: the error of a lobe's irradiance against rows, texels being means.

usage: plot.py ERRORS.tsv FOLDER
"""
import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
import svg_plot  # noqa: E402


def main():
    errors, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    curves = {}
    for row in csv.DictReader(errors.open(), delimiter="\t"):
        if row["texels"] == "means":
            curves.setdefault(row["layout"], []).append((int(row["rows"]), float(row["lobe"])))
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "probe-irradiance.svg").write_text(
        svg_plot.log_lines("Irradiance of a cosine cubed lobe: largest error, in parts of pi", "rows", "error", curves))


if __name__ == "__main__":
    main()
