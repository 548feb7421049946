#!/usr/bin/env python3
"""Writes textures/: a plain of tiles to the horizon (mip maps), a checkerboard and leaves cut out of squares by alpha."""
import math
import pathlib
import random
import struct
import zlib

HEAD = """# Made by make_textures.py.
LookAt 0 1.5 -6   0 .95 0   0 1 0
Camera "perspective" "float fov" 34
Film "rgb" "integer xresolution" 960 "integer yresolution" 540
Sampler "sobol" "integer pixelsamples" 64
Integrator "path" "integer maxdepth" 6

WorldBegin
LightSource "infinite" "rgb L" [ .55 .65 .8 ]
LightSource "distant" "point3 from" [ -3 5 -3 ] "point3 to" [ 0 0 0 ] "rgb L" [ 2.6 2.4 2.1 ]
Texture "tiles" "spectrum" "imagemap" "string filename" "tiles.png" "string filter" "trilinear" "float uscale" 500 "float vscale" 500
Texture "leaf" "spectrum" "imagemap" "string filename" "leaf.png"
Texture "leaf shape" "float" "imagemap" "string filename" "leaf.png"
Texture "check" "spectrum" "checkerboard" "float uscale" 16 "float vscale" 8 "rgb tex1" [ .75 .72 .65 ] "rgb tex2" [ .6 .1 .05 ]
AttributeBegin
  Material "diffuse" "texture reflectance" "tiles"
  Shape "bilinearmesh" "point3 P" [ -500 0 500  500 0 500  -500 0 -500  500 0 -500 ] "point2 uv" [ 0 0  1 0  0 1  1 1 ]
AttributeEnd
AttributeBegin
  Material "coateddiffuse" "texture reflectance" "check" "float roughness" .01
  Translate 1.15 .75 0  Rotate -90 1 0 0  Shape "sphere" "float radius" .75
AttributeEnd
Material "diffusetransmission" "texture reflectance" "leaf" "texture transmittance" "leaf" "float scale" .6
"""


def write_png(path, width, height, pixel):
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixel(x, y)) for y in range(height))
    kind = 6 if len(pixel(0, 0)) == 4 else 2

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def tile(x, y):
    """Four tiles with joints; a ring in one of each two."""
    i, j, u, v = x // 64, y // 64, x % 64, y % 64
    if min(u, v) < 3:
        return (70, 66, 60)
    if (i + j) % 2:
        r = math.hypot(u - 33, v - 33)
        return (30, 74, 120) if 14 < r < 24 else (205, 198, 180)
    return (176, 120, 78)


def leaf(x, y):
    """A leaf along y with veins, on nothing."""
    t = y / 127
    half = 56 * math.sin(math.pi * min(1, t * 1.02)) ** 0.8 * (1 - 0.35 * t) if 0.03 < t < 0.97 else 0
    dx = abs(x - 63.5)
    inside = dx < half or (dx < 2 and t >= 0.9)
    vein = dx < 1.6 or (y - int(dx * 0.7)) % 18 < 2
    green = (118, 160, 52) if vein else (52, 116, 30)
    return (*green, 255 if inside else 0)


def main():
    folder = pathlib.Path(__file__).parent / "textures"
    write_png(folder / "tiles.png", 128, 128, tile)
    write_png(folder / "leaf.png", 128, 128, leaf)
    random.seed(3)
    text = [HEAD]
    for i in range(26):
        a = 2 * math.pi * i / 26 + random.uniform(-0.1, 0.1)
        text.append(f"AttributeBegin\n  Translate -1.15 .05 0  Rotate {math.degrees(a):.1f} 0 1 0  "
                    f"Translate 0 0 .12  Rotate {random.uniform(12, 62):.1f} 1 0 0  Scale .42 {random.uniform(0.9, 1.5):.2f} 1\n"
                    '  Shape "bilinearmesh" "point3 P" [ -.5 0 0  .5 0 0  -.5 1 0  .5 1 0 ] "point2 uv" [ 0 0  1 0  0 1  1 1 ]'
                    ' "texture alpha" "leaf shape"\nAttributeEnd\n')
    (folder / "textures.pbrt").write_text("".join(text))


main()
