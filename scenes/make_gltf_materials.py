#!/usr/bin/env python3
"""Writes gltf-materials/gltf-materials.gltf: the metallic-roughness model and its extensions on balls, under the studio
light that a scene without lights gets."""
import pathlib

from gltf_writer import Gltf

ROWS = [
    ("roughness", [dict(base_colour=(0.55, 0.06, 0.05), roughness=r) for r in (0.05, 0.25, 0.45, 0.7, 1)]),
    ("metal", [dict(base_colour=(0.95, 0.64, 0.37), metallic=1, roughness=r) for r in (0.05, 0.2, 0.35, 0.5, 0.8)]),
    ("anisotropy", [dict(base_colour=(0.8, 0.8, 0.82), metallic=1, roughness=0.35,
                         extensions={"anisotropy": {"anisotropyStrength": s, "anisotropyRotation": a}})
                    for s, a in ((0, 0), (0.4, 0), (0.8, 0), (0.8, 0.785), (0.8, 1.571))]),
    ("clearcoat", [dict(base_colour=(0.02, 0.12, 0.5), metallic=0.6, roughness=0.6,
                        extensions={"clearcoat": {"clearcoatFactor": c, "clearcoatRoughnessFactor": r}})
                   for c, r in ((0, 0), (0.5, 0.02), (1, 0.02), (1, 0.2), (1, 0.4))]),
    ("sheen", [dict(base_colour=(0.12, 0.03, 0.10), roughness=0.9,
                    extensions={"sheen": {"sheenColorFactor": [0.95, 0.75, 0.9], "sheenRoughnessFactor": r}} if r else None)
               for r in (0, 0.15, 0.3, 0.5, 0.9)]),
    ("iridescence", [dict(base_colour=(0.25, 0.25, 0.25), metallic=1, roughness=0.1,
                          extensions={"iridescence": {"iridescenceFactor": 1, "iridescenceIor": 1.5,
                                                      "iridescenceThicknessMaximum": t}})
                     for t in (150, 280, 380, 480, 600)]),
]


def main():
    g = Gltf("make_gltf_materials.py")
    ball = g.sphere()
    floor = g.material("floor", (0.35, 0.35, 0.36), roughness=0.9)
    g.add("floor", g.quad((-30, 0, 30), (30, 0, 30), (30, 0, -30), (-30, 0, -30)), floor)
    for j, (name, row) in enumerate(ROWS):
        for i, settings in enumerate(row):
            material = g.material(f"{name} {i + 1}", **settings)
            g.add(f"{name} {i + 1}", ball, material, translation=[2.3 * (i - 2), 1, 2.3 * (j - 2.5)])
    g.camera((0, 14, 17), (0, 0.2, 0.1), 34, 1.2)
    g.write(pathlib.Path(__file__).parent / "gltf-materials/gltf-materials.gltf")


main()
