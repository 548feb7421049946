#!/usr/bin/env python3
"""usage: sheet.py OUT.pfm COLUMNS [--one] IN.pfm…: pictures side by side in rows on white, exposed each to the same mean, or with --one all
by the mean of the last."""
import array
import sys

GAP = 6


def read(path):
    with open(path, "rb") as file:
        assert file.readline().strip() == b"PF"
        width, height = map(int, file.readline().split())
        assert float(file.readline()) < 0
        values = array.array("f", file.read())
    rows = [values[y * width * 3:(y + 1) * width * 3] for y in reversed(range(height))]
    return width, height, rows


def mean(picture):
    return sum(map(sum, picture)) / max(1, sum(1 for row in picture for v in row if v > 0))


def exposed(picture, by):
    return [[1 - 2.718281828 ** -(0.75 * max(v, 0) / by) for v in row] for row in picture]


def main():
    out, columns = sys.argv[1], int(sys.argv[2])
    one, files = sys.argv[3] == "--one", [a for a in sys.argv[3:] if a != "--one"]
    pictures = [read(file) for file in files]
    means = [mean(p) for _, _, p in pictures]
    pictures = [(w, h, exposed(p, means[-1] if one else m)) for (w, h, p), m in zip(pictures, means)]
    lines = [pictures[i:i + columns] for i in range(0, len(pictures), columns)]
    width = max(sum(p[0] + GAP for p in line) - GAP for line in lines)
    rows = []
    for line in lines:
        height = max(p[1] for p in line)
        for y in range(height):
            row = []
            for w, h, picture in line:
                row += (picture[y] if y < h else [1.0] * 3 * w) + [1.0] * 3 * GAP
            rows.append((row + [1.0] * 3 * width)[:3 * width])
        rows += [[1.0] * 3 * width] * GAP
    rows = rows[:-GAP]
    with open(out, "wb") as file:
        file.write(b"PF\n%d %d\n-1.0\n" % (width, len(rows)))
        for row in reversed(rows):
            array.array("f", row).tofile(file)


main()
