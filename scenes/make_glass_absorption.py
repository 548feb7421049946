#!/usr/bin/env python3
"""Writes glass-absorption/glass-absorption.gltf: steps of one coloured glass; the thicker, the deeper the colour."""
import pathlib

from gltf_writer import Gltf


def glass(g, name, colour, distance):
    return g.material(name, roughness=0, extensions={
        "transmission": {"transmissionFactor": 1}, "ior": {"ior": 1.5},
        "volume": {"thicknessFactor": 1, "attenuationColor": colour, "attenuationDistance": distance}})


def main():
    g = Gltf("make_glass_absorption.py")
    white = g.material("white", (0.8, 0.8, 0.78))
    lamp = g.material("sky", (0, 0, 0), emissiveFactor=[1, 1, 1], extensions={"emissive_strength": {"emissiveStrength": 0.9}})
    g.add("floor", g.quad((-20, 0, 20), (20, 0, 20), (20, 0, -20), (-20, 0, -20)), white)
    g.add("ceiling light", g.quad((-9, 9, -9), (9, 9, -9), (9, 9, 9), (-9, 9, 9)), lamp)
    g.add("back light", g.quad((-12, 0, -9), (12, 0, -9), (12, 9, -9), (-12, 9, -9)), lamp)
    green, amber = glass(g, "green glass", [0.25, 0.8, 0.45], 0.8), glass(g, "amber glass", [0.95, 0.55, 0.12], 0.7)
    for i in range(5):
        thickness = 0.12 * 2 ** i
        g.add(f"slab {i + 1}", g.box((-0.55, 0.05, -thickness), (0.55, 1.55, 0)), green, translation=[1.45 * (i - 2), 0, -0.6])
    ball = g.sphere()
    for i in range(5):
        r = 0.16 + 0.11 * i
        g.add(f"ball {i + 1}", ball, amber, translation=[1.45 * (i - 2), r + 0.01, 1.6], scale=[r, r, r])
    g.camera((0, 3.4, 8.2), (0, 0.62, 0.3), 31, 1.6)
    g.write(pathlib.Path(__file__).parent / "glass-absorption/glass-absorption.gltf")


main()
