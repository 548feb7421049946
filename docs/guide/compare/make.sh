#!/usr/bin/env bash
# Makes the picture of compare.md again: docs/guide/compare/make.sh PATH_TO_LAMBERT
set -euo pipefail
lambert=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$lambert" render --spp 16 --seed 1 --resolution 240x240 -o few.exr >/dev/null
"$lambert" render --spp 1024 --seed 2 --resolution 240x240 -o many.exr >/dev/null
"$lambert" compare few.exr many.exr --metric flip --heat heat.png --heat-of flip >/dev/null || true
"$lambert" composite 'few.exr over (many.exr translate 250 0) over (heat.png translate 500 0)' --resolution 740x240 -o "$here/heat.png"
