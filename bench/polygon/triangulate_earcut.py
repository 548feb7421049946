#!/usr/bin/python3
"""Milliseconds that mapbox's earcut takes for the polygons of a folder (python3-mapbox-earcut; the C++ library behind it).

usage: triangulate_earcut.py FOLDER      after  bench_triangulate FOLDER
"""
import pathlib
import sys
import time

import mapbox_earcut
import numpy


def area(vertices, ends):
    total = 0.0
    for first, last in zip([0, *ends], ends):
        x, y = (vertices[first:last] - vertices[first]).T
        total += 0.5 * float(numpy.dot(x, numpy.roll(y, -1)) - numpy.dot(y, numpy.roll(x, -1)))
    return total


for path in sorted(pathlib.Path(sys.argv[1]).glob("*.txt"), key=lambda p: int(p.stem.split("-")[1])):
    with open(path) as file:
        ends = numpy.array([int(e) for e in file.readline().split()], dtype=numpy.uint32)
        vertices = numpy.loadtxt(file, dtype=numpy.float64)
    best, total, runs = float("inf"), 0.0, 0
    while runs < 3 or (runs < 50 and total < 0.3):
        start = time.thread_time()
        corners = mapbox_earcut.triangulate_float64(vertices, ends)
        elapsed = time.thread_time() - start
        best, total, runs = min(best, elapsed), total + elapsed, runs + 1
        if elapsed > 10:
            break
    a, b, c = (vertices[corners.reshape(-1, 3)[:, i]] for i in range(3))
    u, v = b - a, c - a
    covered = 0.5 * float(numpy.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]).sum())
    error = abs(covered - area(vertices, ends.tolist())) / area(vertices, ends.tolist())
    print(f"{path.stem:16} {1e3 * best:9.3f}   relative error of area {error:.1e}", flush=True)
