#!/usr/bin/env python3
"""Writes environment/sky.hdr, an evening sky as a radiance map in latitude and longitude, and a scene lit by nothing else."""
import math
import pathlib

SCENE = """# Made by make_environment.py. All light comes from sky.hdr: its sun has 500 times the radiance of the sky about it.
LookAt 0 3.2 -8   0 .85 0   0 1 0
Camera "perspective" "float fov" 26
Film "rgb" "integer xresolution" 960 "integer yresolution" 540
Sampler "sobol" "integer pixelsamples" 64
Integrator "path" "integer maxdepth" 10

WorldBegin
LightSource "infinite" "string filename" "sky.hdr"
AttributeBegin
  Material "diffuse" "rgb reflectance" [ .4 .37 .33 ]
  Translate 0 -.01 0  Rotate -90 1 0 0  Shape "disk" "float radius" 200
AttributeEnd
AttributeBegin
  Material "conductor" "spectrum eta" "metal-Ag-eta" "spectrum k" "metal-Ag-k"
  Translate -2.1 1 0  Shape "sphere" "float radius" 1
AttributeEnd
AttributeBegin
  Material "coateddiffuse" "rgb reflectance" [ .6 .08 .05 ] "float roughness" .01
  Translate 0 1 .4  Shape "sphere" "float radius" 1
AttributeEnd
AttributeBegin
  Material "diffuse" "rgb reflectance" [ .75 .75 .75 ]
  Translate 2.1 1 0  Shape "sphere" "float radius" 1
AttributeEnd
"""
WIDTH, HEIGHT = 192, 96


def sky(theta, phi):
    """Radiance towards the polar angle theta and the azimuth phi."""
    d = (math.sin(theta) * math.sin(phi), math.cos(theta), -math.sin(theta) * math.cos(phi))
    sun = (-0.62, 0.33, -0.71)
    near = sum(a * b for a, b in zip(d, sun)) / math.sqrt(sum(a * a for a in sun))
    if d[1] < 0:
        return (0.10, 0.085, 0.07)
    h = d[1] ** 0.45
    colour = [a + (b - a) * h for a, b in zip((1.15, 0.72, 0.45), (0.09, 0.2, 0.5))]
    glow = 1.6 * max(near, 0) ** 24
    hills = 0.06 + 0.035 * math.sin(5 * phi) + 0.02 * math.sin(11 * phi + 1)
    if d[1] < hills:
        return (0.05, 0.06, 0.09)
    if near > 0.995:
        return (520, 340, 180)
    return tuple(c + glow * g for c, g in zip(colour, (1, 0.62, 0.3)))


def rgbe(colour):
    largest = max(colour)
    mantissa, exponent = math.frexp(largest)
    return bytes([*(int(c * mantissa * 256 / largest) for c in colour), exponent + 128])


def main():
    folder = pathlib.Path(__file__).parent / "environment"
    pixels = b"".join(rgbe(sky(math.pi * (y + 0.5) / HEIGHT, 2 * math.pi * ((x + 0.5) / WIDTH - 0.5)))
                      for y in range(HEIGHT) for x in range(WIDTH))
    (folder / "sky.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH) + pixels)
    (folder / "environment.pbrt").write_text(SCENE)


main()
