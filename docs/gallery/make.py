"""Renders the pictures of pictures.json with their own commands, and writes README.md, which shows them."""
import argparse
import json
import pathlib
import shlex
import subprocess
import tempfile

import layers

GALLERY = pathlib.Path(__file__).resolve().parent
ROOT = GALLERY.parent.parent


def render(binary, picture, png_folder):
    target = GALLERY / picture["file"]
    with tempfile.TemporaryDirectory() as folder:
        exr = pathlib.Path(folder) / "layers.exr"
        outputs = ["-o", exr if "layer" in picture else target]
        if png_folder and "layer" not in picture:
            outputs += ["-o", pathlib.Path(png_folder) / target.with_suffix(".png").name]
        subprocess.run([binary, "render", *shlex.split(picture["command"]), "--quiet", *outputs], cwd=ROOT, check=True)
        if "layer" in picture:
            layers.show(exr, picture["layer"], target)


def page(pictures):
    lines = ["# Gallery", "", "Written by `make.sh` from `pictures.json`; `./dev gallery` renders every picture again. All scenes are in",
             "[scenes](../../scenes) (without a scene the Cornell box is rendered).", ""]
    for picture in pictures:
        if "section" in picture:
            lines += [f"## {picture['section']}", ""]
        output = "layers.exr" if "layer" in picture else picture["file"]
        lines += [f"![{picture['caption']}]({picture['file']})", "", f"{picture['caption']}.", "",
                  f"    lambert render {picture['command']} -o {output}", ""]
    (GALLERY / "README.md").write_text("\n".join(lines).rstrip() + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("binary", type=pathlib.Path)
    parser.add_argument("files", nargs="*", help="only these pictures")
    parser.add_argument("--png", help="a folder for PNG copies")
    arguments = parser.parse_intermixed_args()
    pictures = json.loads((GALLERY / "pictures.json").read_text())
    for picture in pictures:
        if not arguments.files or picture["file"] in arguments.files:
            render(arguments.binary.resolve(), picture, arguments.png)
    page(pictures)


main()
