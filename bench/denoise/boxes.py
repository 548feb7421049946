"""The Cornell box of scenes/ with other things in it, as pbrt files: what a denoiser has to get right."""
import pathlib

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

GLOSSY = """
AttributeBegin
  Material "conductor" "spectrum eta" "metal-Cu-eta" "spectrum k" "metal-Cu-k" "float roughness" .05
  Translate 185 90 170  Shape "sphere" "float radius" 90
AttributeEnd
AttributeBegin
  Material "coateddiffuse" "rgb reflectance" [ .05 .12 .5 ] "float roughness" .02
  Translate 390 100 330  Shape "sphere" "float radius" 100
AttributeEnd
"""

TEXTURED = """
Texture "tiles" "spectrum" "imagemap" "string filename" "%s/textures/tiles.png" "string filter" "trilinear" "float uscale" 3 "float vscale" 3
Texture "check" "spectrum" "checkerboard" "float uscale" 24 "float vscale" 24 "rgb tex1" [ .75 .72 .65 ] "rgb tex2" [ .2 .1 .05 ]
AttributeBegin
  Material "diffuse" "texture reflectance" "check"
  Shape "bilinearmesh" "point3 P" [ 549 1 558  1 1 558  555 548 558  1 548 558 ] "point2 uv" [ 0 0  1 0  0 1  1 1 ]
AttributeEnd
AttributeBegin
  Material "diffuse" "texture reflectance" "tiles"
  Shape "bilinearmesh" "point3 P" [ 1 .5 558  549 .5 558  1 .5 1  552 .5 1 ] "point2 uv" [ 0 0  1 0  0 1  1 1 ]
AttributeEnd
AttributeBegin                                   # a mirror on the right wall
  Material "conductor" "spectrum eta" "metal-Ag-eta" "spectrum k" "metal-Ag-k" "float roughness" 0
  Shape "bilinearmesh" "point3 P" [ 2 60 80  2 60 520  2 420 80  2 420 520 ]
AttributeEnd
AttributeBegin                                   # a pane before the back wall
  Material "dielectric" "float eta" 1.5
  Translate 400 90 150  Shape "sphere" "float radius" 85
AttributeEnd
""" % SCENES


def box(extra, keep_blocks=False):
    text = (SCENES / "cornell-box/cornell-box.pbrt").read_text()
    if not keep_blocks:
        head, tail = text.split("# short block")
        text = head + tail[tail.index("# The lamp"):]
    return text + extra


def lens(text):
    """In focus is the front of the room."""
    return text.replace('"float fov"', '"float lensradius" 25 "float focaldistance" 980 "float fov"')


def write(folder):
    """The files' paths by name."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    texts = {"glossy": box(GLOSSY), "textured": box(TEXTURED), "lens": lens(box(TEXTURED + GLOSSY.split("AttributeEnd")[0] + "AttributeEnd\n"))}
    paths = {}
    for name, text in texts.items():
        paths[name] = folder / f"{name}.pbrt"
        paths[name].write_text(text)
    return paths
