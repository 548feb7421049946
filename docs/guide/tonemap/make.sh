#!/usr/bin/env bash
# usage: docs/guide/tonemap/make.sh LAMBERT: makes the pictures of docs/guide/tonemap.md again.
set -euo pipefail
lambert=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
scenes=../../../scenes
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
# The scene of three balls, seen against its sun: 20000 to 1.
{
  echo "LookAt 1.5 1.4 7  -1.5 1.5 0  0 1 0"
  grep -v LookAt $scenes/environment/environment.pbrt | sed 's/"float fov" 26/"float fov" 62/'
} >"$work/sunset.pbrt"
cp $scenes/environment/sky.hdr "$work"
"$lambert" render "$work/sunset.pbrt" --resolution 640x360 --spp 256 --set clamp=30 --quiet -o "$work/sunset.exr" >/dev/null
map() { "$lambert" tonemap "$work/sunset.exr" "$@" >/dev/null; }

map --montage --tile-width 300 --exposure auto -o montage.jpg
for name in linear reinhard filmic aces agx; do map --operator $name --exposure auto -o "$work/$name.exr"; done
for name in darkest-range darkest-pixels photographic photographic-local reinhard-devlin drago durand fattal mertens; do
  map --operator $name -o "$work/$name.exr"
done
map --operator linear --set white=0 -o "$work/linear-largest.exr"
map --operator reinhard --exposure auto --channels rgb -o "$work/reinhard-rgb.exr"
for picture in "$work"/*.exr; do
  name=$(basename "$picture" .exr)
  [ "$name" = sunset ] || "$lambert" tonemap "$picture" --operator linear -o "$name.jpg" >/dev/null
done
python3 craik_o_brien.py "$work/craik.pfm"
"$lambert" tonemap "$work/craik.pfm" --operator linear -o craik-o-brien.png >/dev/null
