#!/usr/bin/env python3
"""Writes many-lights/many-lights.pbrt: a hall with 500 small lamps of many colours; the light tree finds the near ones."""
import colorsys
import pathlib
import random

HEAD = """# Made by make_many_lights.py: 500 small lamps over a glossy floor.
LookAt 0 3.2 -13   0 1.3 0   0 1 0
Camera "perspective" "float fov" 40
Film "rgb" "integer xresolution" 960 "integer yresolution" 540
Sampler "sobol" "integer pixelsamples" 64
Integrator "path" "integer maxdepth" 3

WorldBegin
AttributeBegin
  Material "coateddiffuse" "rgb reflectance" [ .28 .28 .3 ] "float roughness" .02
  Shape "bilinearmesh" "point3 P" [ -14 0 14  14 0 14  -14 0 -14  14 0 -14 ]
AttributeEnd
AttributeBegin
  Material "diffuse" "rgb reflectance" [ .6 .58 .55 ]
  Shape "bilinearmesh" "point3 P" [ -14 0 8  -14 8 8  14 0 8  14 8 8 ]
AttributeEnd
Material "diffuse" "rgb reflectance" [ .7 .7 .7 ]
"""


def main():
    random.seed(1)
    text = [HEAD]
    for x in (-6, -3, 0, 3, 6):
        for z in (-4, 0, 4):
            text.append(f"AttributeBegin\n  Translate {x} 0 {z}  Rotate -90 1 0 0\n"
                        "  Shape \"cylinder\" \"float radius\" .35 \"float zmin\" 0 \"float zmax\" 2.4 \"bool caps\" true\nAttributeEnd\n")
    for _ in range(500):
        x, y, z = random.uniform(-9, 9), random.uniform(0.08, 3.2), random.uniform(-7, 7)
        r, g, b = colorsys.hsv_to_rgb(random.random(), random.uniform(0.3, 0.9), 1)
        text.append(f"AttributeBegin\n  AreaLightSource \"diffuse\" \"rgb L\" [ {r:.3f} {g:.3f} {b:.3f} ] \"float scale\" 4\n"
                    f"  Translate {x:.3f} {y:.3f} {z:.3f}\n  Shape \"sphere\" \"float radius\" .06\nAttributeEnd\n")
    (pathlib.Path(__file__).parent / "many-lights/many-lights.pbrt").write_text("".join(text))


main()
