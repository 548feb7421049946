#!/usr/bin/env python3
"""Writes prism/prism.gltf: light from a slit goes through a bar of flint glass and falls apart on the wall.

Seen from the side: the slit is a long, thin lamp in a black box, the prism an equilateral bar beside it. Both run along
z, so that each point of the wall's rainbow sees a long stripe of lamp in its own colour.
"""
import math
import pathlib

from gltf_writer import Gltf

SIDE = 0.06          # of the prism [m]
SLIT = 0.036         # height of the lamp
LENGTH = 1.2         # of lamp and prism


def main():
    g = Gltf("make_prism.py")
    white = g.material("screen", (0.9, 0.9, 0.9), 1, 0.42)
    black = g.material("black", (0.01, 0.01, 0.01))
    glass = g.material("flint glass", (1, 1, 1), 0, 0, extensions={
        "transmission": {"transmissionFactor": 1}, "volume": {"thicknessFactor": SIDE}, "ior": {"ior": 1.62},
        "dispersion": {"dispersion": 3}})
    lamp = g.material("lamp", (0, 0, 0), emissiveFactor=[1, 1, 1],
                      extensions={"emissive_strength": {"emissiveStrength": 60}})
    z0, z1 = -LENGTH / 2, LENGTH / 2
    h = SIDE / 2
    # Apex up; light comes from the left and below, leaves to the right and down.
    profile = [(-h, -h / math.sqrt(3)), (h, -h / math.sqrt(3)), (0, SIDE / math.sqrt(3))]
    g.add("prism", g.prism(profile, z0, z1), glass)
    g.add("wall", g.quad((0.7, -0.75, -1), (0.7, -0.75, 1), (0.7, 0.3, 1), (0.7, 0.3, -1)), white)
    # The lamp, 0.22 m to the left, 25 degrees below the level, facing the prism's left face.
    direction = math.radians(24)
    cx, cy = -0.22 * math.cos(direction), -0.22 * math.sin(direction)
    tx, ty = -math.sin(direction), math.cos(direction)
    a, b = (cx - tx * SLIT / 2, cy - ty * SLIT / 2), (cx + tx * SLIT / 2, cy + ty * SLIT / 2)
    g.add("lamp", g.quad((*a, z1), (*a, z0), (*b, z0), (*b, z1)), lamp)
    # Shutters above and below the prism let no light pass beside it.
    g.add("shutter above", g.box((-0.02, SIDE / math.sqrt(3) - 0.012, z0 - 0.3), (-0.005, 0.6, z1 + 0.3)), black)
    g.add("shutter below", g.box((-0.035, -0.8, z0 - 0.3), (-0.02, -h / math.sqrt(3) + 0.004, z1 + 0.3)), black)
    g.camera((0.08, -0.62, 0.0), (0.7, -0.33, 0.0), 36, 2.6)
    g.write(pathlib.Path(__file__).parent / "prism/prism.gltf")


main()
