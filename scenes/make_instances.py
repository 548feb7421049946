#!/usr/bin/env python3
"""Writes instances/instances.pbrt: a forest of 103,680 trees from one tree, by instances.

A grove of 80 trees is one object; 1296 instances of it, turned by quarter turns, stand on a grid.
"""
import math
import pathlib
import random

HEAD = """# Made by make_instances.py: 103,680 trees, one of them stored. A grove is an object of 80 trees.
LookAt 0 13 -44   0 2 20   0 1 0
Camera "perspective" "float fov" 34
Film "rgb" "integer xresolution" 960 "integer yresolution" 480
Sampler "sobol" "integer pixelsamples" 64
Integrator "path" "integer maxdepth" 4

WorldBegin
LightSource "infinite" "rgb L" [ .55 .7 1 ]
LightSource "distant" "point3 from" [ -6 5 -4 ] "point3 to" [ 0 0 0 ] "rgb L" [ 3.2 2.8 2.1 ]
AttributeBegin
  Material "diffuse" "rgb reflectance" [ .16 .2 .07 ]
  Shape "bilinearmesh" "point3 P" [ -900 0 1500  900 0 1500  -900 0 -60  900 0 -60 ]
AttributeEnd
MakeNamedMaterial "needles" "string type" "diffusetransmission" "rgb reflectance" [ .05 .19 .04 ] "rgb transmittance" [ .03 .09 .01 ]
MakeNamedMaterial "bark" "string type" "diffuse" "rgb reflectance" [ .19 .11 .06 ]
"""


def cone(x, z, base, height, radius, sides=8):
    """A skirt of triangles round a point."""
    rim = [(x + radius * math.cos(2 * math.pi * i / sides), base, z + radius * math.sin(2 * math.pi * i / sides)) for i in range(sides)]
    points = [(x, base + height, z), *rim]
    indices = [k for i in range(sides) for k in (0, 1 + (i + 1) % sides, 1 + i)]
    return points, indices


def main():
    random.seed(7)
    text = [HEAD, 'ObjectBegin "grove"\n']
    points, indices, trunks = [], [], []
    for _ in range(80):
        x, z, s = random.uniform(-7, 7), random.uniform(-7, 7), random.uniform(0.6, 1.25)
        for level in range(3):
            p, t = cone(x, z, s * (0.7 + 0.95 * level), s * 1.5, s * (1.0 - 0.26 * level))
            indices += [i + len(points) for i in t]
            points += p
        trunks.append(f'AttributeBegin Translate {x:.2f} 0 {z:.2f} Rotate -90 1 0 0 Shape "cylinder" "float radius" {0.13 * s:.3f} '
                      f'"float zmin" 0 "float zmax" {s:.2f} AttributeEnd\n')
    numbers = " ".join(f"{v:.2f}" for p in points for v in p)
    text += ['NamedMaterial "needles"\n', f'Shape "trianglemesh" "point3 P" [ {numbers} ]\n  "integer indices" [ {" ".join(map(str, indices))} ]\n',
             'NamedMaterial "bark"\n', *trunks, "ObjectEnd\n"]
    for row in range(36):
        for column in range(36):
            x, z = 14 * (column - 17.5), 14 * row - 18
            text.append(f'AttributeBegin Translate {x:g} 0 {z} Rotate {90 * random.randrange(4)} 0 1 0 ObjectInstance "grove" AttributeEnd\n')
    (pathlib.Path(__file__).parent / "instances/instances.pbrt").write_text("".join(text))


main()
