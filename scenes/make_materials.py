#!/usr/bin/env python3
"""Writes materials/materials.pbrt: a shelf of balls, one material a row, rougher from left to right."""
import pathlib

HEAD = """# Made by make_materials.py: one material a row, the rougher the further to the right.
# From the back: gold, copper, silver, coated copper; then glass, coated diffuse, and a row of thin glass,
# diffuse transmission, diffuse and three mixtures.
LookAt 0 6.2 -9.2   0 .1 -.25   0 1 0
Camera "perspective" "float fov" 32
Film "rgb" "integer xresolution" 960 "integer yresolution" 640
Sampler "sobol" "integer pixelsamples" 64
Integrator "path" "integer maxdepth" 24

WorldBegin
LightSource "infinite" "rgb L" [ .85 .9 1 ]
AttributeBegin                                   # a soft light above and to the left
  AreaLightSource "diffuse" "rgb L" [ 2.6 2.5 2.35 ]
  Shape "bilinearmesh" "point3 P" [ -9 5 -5   0 10 -5   -9 5 5   0 10 5 ]
AttributeEnd
AttributeBegin                                   # a strip to the right, for highlights
  AreaLightSource "diffuse" "rgb L" [ 5 5.6 6.5 ]
  Shape "bilinearmesh" "point3 P" [ 7 .5 -4   7 .5 4   7 4 -4   7 4 4 ]
AttributeEnd

Texture "tiles" "spectrum" "checkerboard" "float uscale" 40 "float vscale" 40
  "rgb tex1" [ .34 .33 .31 ] "rgb tex2" [ .12 .13 .15 ]
AttributeBegin
  Material "diffuse" "texture reflectance" "tiles"
  Shape "bilinearmesh" "point3 P" [ -16 0 18  16 0 18  -16 0 -14  16 0 -14 ] "point2 uv" [ 0 0  1 0  0 1  1 1 ]
AttributeEnd
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ .6 .05 .04 ]
MakeNamedMaterial "gold" "string type" "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k" "float roughness" .02
MakeNamedMaterial "mirror" "string type" "conductor" "spectrum eta" "metal-Ag-eta" "spectrum k" "metal-Ag-k"
MakeNamedMaterial "white" "string type" "diffuse" "rgb reflectance" [ .75 .75 .75 ]
MakeNamedMaterial "blue" "string type" "coateddiffuse" "rgb reflectance" [ .03 .10 .45 ] "float roughness" .002
Texture "spots" "float" "checkerboard" "float uscale" 16 "float vscale" 8
"""
ROUGHNESS = [0, 0.005, 0.03, 0.1, 0.25, 0.6]


def metal(name):
    return lambda r: f'"conductor" "spectrum eta" "metal-{name}-eta" "spectrum k" "metal-{name}-k" "float roughness" {r}'


def coated_copper(r):
    return ('"coatedconductor" "float interface.roughness" .001 "spectrum conductor.eta" "metal-Cu-eta" '
            f'"spectrum conductor.k" "metal-Cu-k" "float conductor.roughness" {max(r, 0.01)}')


ROWS = [metal("Au"), metal("Cu"), metal("Ag"), coated_copper,
        lambda r: f'"dielectric" "float eta" 1.5 "float roughness" {r}',
        lambda r: f'"coateddiffuse" "rgb reflectance" [ .04 .22 .10 ] "float roughness" {r}']
LAST = ['Material "thindielectric" "float eta" 1.5',
        'Material "diffusetransmission" "rgb reflectance" [ .3 .2 .05 ] "rgb transmittance" [ .6 .4 .1 ]',
        'NamedMaterial "red"',
        'Material "mix" "string materials" [ "red" "gold" ] "float amount" .5',
        'Material "mix" "string materials" [ "white" "mirror" ] "texture amount" "spots"',
        'Material "mix" "string materials" [ "blue" "gold" ] "texture amount" "spots"']


def ball(x, z, material):
    return f"AttributeBegin\n  {material}\n  Translate {x:.2f} .42 {z:.2f}  Rotate -90 1 0 0\n  Shape \"sphere\" \"float radius\" .42\nAttributeEnd\n"


def main():
    text = [HEAD]
    for j, row in enumerate([*ROWS, LAST]):
        for i, roughness in enumerate(ROUGHNESS):
            material = row[i] if isinstance(row, list) else f"Material {row(roughness)}"
            text.append(ball(1.05 * (i - 2.5), 1.05 * (3 - j), material))
    (pathlib.Path(__file__).parent / "materials/materials.pbrt").write_text("".join(text))


main()
