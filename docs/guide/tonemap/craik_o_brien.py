#!/usr/bin/env python3
"""Writes the Craik-O'Brien(-Cornsweet) picture as PFM: two fields of one luminance, parted by an edge that fades to either side. In the
lower third the edge is covered."""
import array
import math
import sys

WIDTH, HEIGHT, GREY = 480, 240, 0.22


def light(x, y):
    d = (x + 0.5) / WIDTH - 0.5
    if y > HEIGHT * 2 // 3 and abs(d) < 0.16:
        return 0.04
    return GREY * (1 + math.copysign(0.32 * math.exp(-abs(d) / 0.045), -d))


with open(sys.argv[1], "wb") as out:
    out.write(b"PF\n%d %d\n-1.0\n" % (WIDTH, HEIGHT))
    for y in reversed(range(HEIGHT)):
        out.write(array.array("f", [v for x in range(WIDTH) for v in [light(x, y)] * 3]).tobytes())
