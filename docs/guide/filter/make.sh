#!/usr/bin/env bash
# usage: docs/guide/filter/make.sh LAMBERT: makes the pictures of docs/guide/filter.md again.
set -euo pipefail
lambert=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
scenes=$(realpath ../../../scenes)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
image() { "$lambert" image "$@" >/dev/null; }

"$lambert" render --quiet "$scenes/cornell-box/cornell-box.pbrt" --resolution 256x256 --spp 128 -o "$work/box.exr" >/dev/null

# Enlarged by every kernel: 28 pixels become 168.
image resize "$work/box.exr" --size 28x28 --filter box -o "$work/tiny.exr"
for filter in box triangle gaussian mitchell catmull-rom lanczos blackman-harris; do
  image resize "$work/tiny.exr" --size 168x168 --filter "$filter" -o "enlarged-$filter.png"
done

# Made smaller without a filter (one sample per pixel), and with one.
image plane -o "$work/plane.exr" --lookup nearest --size 1400x700
image resize "$work/plane.exr" --size 200x100 --filter box --radius 0.1 -o shrunk-sampled.png
image resize "$work/plane.exr" --size 200x100 --filter box -o shrunk-box.png
image resize "$work/plane.exr" --size 200x100 --filter lanczos -o shrunk-lanczos.png

for kernel in box bartlett; do
  image plane -o "$work/samples.exr" --lookup nearest --size 600x600
  image resolve "$work/samples.exr" --filter "$kernel" -o "resolve-$kernel.png"
done
image plane -o resolve-none.png --lookup nearest --size 200x200

image blur "$work/box.exr" --sigma 6 -o "$work/gaussian.exr"
image blur "$work/box.exr" --filter box --radius 10 -o "$work/blurred-box.exr"
image blur "$work/box.exr" --filter bartlett --radius 14 -o "$work/bartlett.exr"
for blur in gaussian blurred-box bartlett; do
  image resize "$work/$blur.exr" --size 200x200 -o "blur-${blur#blurred-}.jpg"
done

image mipmap "$work/box.exr" -o levels.jpg
image resize "$work/box.exr" --size 128x128 -o "$work/box128.exr"
image mipmap "$work/box128.exr" --packed -o packed.png

image plane -o lookups.png --size 220x220
image plane "$scenes/textures/tiles.png" -o lookups-tiles.png --size 220x220
image plane -o lookups-truth.png --lookup nearest --samples 16 --size 220x220
for edge in clamp repeat mirror black; do
  image plane "$scenes/textures/tiles.png" -o "edge-$edge.png" --lookup anisotropic --edge "$edge" --size 200x120
done

image resize "$scenes/textures/leaf.png" --size 192x192 -o "$work/leaf.png"
image resize "$work/leaf.png" --size 192x192 -o gaps-before.jpg
for method in push-pull nearest; do
  image fill-gaps "$work/leaf.png" --method "$method" -o "gaps-$method.jpg"
done
