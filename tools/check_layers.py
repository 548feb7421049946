#!/usr/bin/env python3
"""Refuses includes that layers.txt does not allow, a cyclic table, and third-party headers in headers of modules
(those that only tests include apart).

usage: check_layers.py [PROJECT_ROOT]
"""
import pathlib
import re
import sys

THIRD_PARTY = re.compile(r"^(embree|OpenEXR|Imf|Imath|tiny_gltf|tiny_obj|CLI/|nlohmann|spdlog|fmt/|tbb/|draco|meshoptimizer|png|jpeg|tiff|webp|zlib)")


def read_layers(path):
    table = {}
    for line in path.read_text().splitlines():
        line = line.split("#")[0].strip()
        if line:
            name, uses = line.split(":")
            table[name.strip()] = uses.split()
    return table


def check_acyclic(table):
    """The modules stand in order: each may only name modules above it."""
    seen = set()
    for name, uses in table.items():
        for used in uses:
            if used not in seen:
                yield f"layers.txt: '{name}' names '{used}', which does not stand above it"
        seen.add(name)


def check_includes(root, table):
    source = root / "src" / "lambert"
    for path in sorted(source.rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        module = path.relative_to(source).parts[0]
        if module not in table:
            yield f"{path.relative_to(root)}: module '{module}' is not in layers.txt"
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            where = f"{path.relative_to(root)}:{number}"
            ours = re.match(r'\s*#\s*include\s*["<]lambert/(\w+)/', line)
            if ours and ours[1] != module and ours[1] not in table[module]:
                yield f"{where}: {module} may not include {ours[1]}"
            theirs = re.match(r"\s*#\s*include\s*<([^>]+)>", line)
            if theirs and path.suffix == ".h" and not path.stem.endswith("_test_tools") and THIRD_PARTY.match(theirs[1]):
                yield f"{where}: third-party header <{theirs[1]}> belongs inside a .cpp file"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    table = read_layers(root / "layers.txt")
    problems = [*check_acyclic(table), *check_includes(root, table)]
    print("\n".join(problems) if problems else "layers: every include goes the allowed way")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
