"""Renders the pictures of pictures.json with their own commands, makes those of the guides again by their own scripts, and
writes README.md, which shows them all."""
import argparse
import json
import pathlib
import re
import shlex
import subprocess
import tempfile

import layers

GALLERY = pathlib.Path(__file__).resolve().parent
ROOT = GALLERY.parent.parent
GUIDE = ROOT / "docs" / "guide"
GUIDES = ["polygon", "lab", "filter", "composite", "hdr", "probe", "tonemap", "compare", "denoise", "performance"]


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


def guide_pictures(name):
    """The section of one guide: its title and its pictures in their order, each over its caption."""
    text = (GUIDE / f"{name}.md").read_text()
    title = re.search(r"^# (.*)", text).group(1)
    lines = [f"## {title}", "", f"Explained in [{name}.md](../guide/{name}.md).", ""]
    for caption, path in re.findall(r"!\[([^\]]*)\]\(([^ )]+)", text):
        caption = caption or pathlib.Path(path).stem.replace("-", " ")
        lines += [f"![{caption}](../guide/{path})", "", f"{caption[:1].upper()}{caption[1:]}.", ""]
    return lines


def page(pictures):
    lines = ["# Gallery", "", "Written by `make.sh`; `./dev gallery` makes every picture again, the plots of measurements apart. Pictures of",
             "scenes come from `pictures.json`, those of the guides from the scripts beside them. All scenes are in",
             "[scenes](../../scenes) (without a scene the Cornell box is rendered).", ""]
    for picture in pictures:
        if "section" in picture:
            lines += [f"## {picture['section']}", ""]
        output = "layers.exr" if "layer" in picture else picture["file"]
        lines += [f"![{picture['caption']}]({picture['file']})", "", f"{picture['caption']}.", "",
                  f"    lambert render {picture['command']} -o {output}", ""]
    for name in GUIDES:
        lines += guide_pictures(name)
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
    if not arguments.files:
        for script in sorted(GUIDE.glob("*/make.sh")):
            subprocess.run([script, arguments.binary.resolve()], check=True)
    page(pictures)


main()
