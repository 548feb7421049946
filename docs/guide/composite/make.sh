#!/usr/bin/env bash
# usage: docs/guide/composite/make.sh LAMBERT: makes the pictures of docs/guide/composite.md again.
set -euo pipefail
lambert=$(realpath "$1")
scenes=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../../scenes")
cd "$(dirname "${BASH_SOURCE[0]}")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
composite() { "$lambert" composite --quiet "$@"; }

# The classical figure: a disk A and a square B under every operator, in a table of four columns.
a='(colour(0.8,0.1,0.05) mask disk(40,40,28))' b='(colour(0.05,0.15,0.7) mask rectangle(40,40,36,36))'
table='colour(0.9,0.9,0.9)' i=0
for op in clear a b over rover in rin out rout atop ratop xor; do
  table="((($a $op $b) over (colour(1,1,1) mask rectangle(2,2,80,80))) translate $((84 * (i % 4))) $((84 * (i / 4)))) over $table"
  i=$((i + 1))
done
composite "$table" --resolution 336x252 -o operators.png

# 0.3 of red and 0.6 of blue: over, in, out, atop, xor on white.
strip='colour(1,1,1)' i=0
for op in a b over in out atop xor; do
  strip="((colour(0.3,0,0,0.3) $op colour(0,0,0.6,0.6)) crop $((48 * i)) 0 44 44) over $strip"
  i=$((i + 1))
done
composite "$strip" --resolution 332x44 -o coverage.png

# A disk before blue, its light and alpha turned down.
sheet='colour(0.05,0.15,0.45)' i=0
for word in '' 'darken 0.5' 'dissolve 0.5' 'opaque 0.5' 'opaque 0'; do
  sheet="(((colour(0.8,0.4,0.05) mask disk(40,40,30)) $word) translate $((84 * i)) 0) over $sheet"
  i=$((i + 1))
done
composite "$sheet" --resolution 416x80 -o light.png

# A matte and what may be done to it.
matte='(polygon(40,8,72,30,58,70,40,50,14,66,10,24) blur 1)' sheet='colour(0.18,0.2,0.24)' i=0
for word in '' 'erode 6' 'dilate 6' 'edge 3' 'blur 5' 'invert'; do
  sheet="((colour(1,0.85,0.5) mask ($matte $word)) crop 0 0 80 80 translate $((84 * i)) 0) over $sheet"
  i=$((i + 1))
done
composite "$sheet" --resolution 500x80 -o mattes.png

# A film element: a render, cut by its depth, a glow of its highlights, a title that darkens the plate behind it.
"$lambert" render --quiet --resolution 320x320 --spp 32 --aov depth,albedo -o "$work/box.exr" >/dev/null
beauty="$work/box.exr"
composite "($beauty blur 12 darken 0.5) plus ($beauty gain 0.85 0.95 1.15)" -o "$work/lit.exr" --depth half
composite "((colour(1,0.9,0.6) mask rectangle(30,262,260,8)) dissolve 0.9) over
  ((colour(0,0,0) mask (rectangle(20,240,280,60) blur 6)) dissolve 0.6) over
  (colour(1.6,1.1,0.5,0) mask (disk(250,60,10) blur 14)) plus $work/lit.exr" -o film.jpg
composite "$beauty layer albedo" -o albedo.jpg

# Keying: a subject before an uneven green, and what the key makes of it before another plate.
green='(colour(0.05,0.6,0.1) mask gradient(-160,0,160,0)) over colour(0.02,0.3,0.05)'
composite "(colour(0.5,0.3,0.2) mask (disk(70,60,40) blur 3)) over ($green)" --resolution 160x120 -o "$work/shot.exr"
composite "$work/shot.exr" -o shot.png
composite "($work/shot.exr key-screen 0.045 0.52 0.09 low=0.1) over (colour(0.2,0.3,0.6) mask gradient(0,140,0,-40)) over colour(0.02,0.02,0.05)" -o keyed.png

# Depth: two fogs of one render.
composite "(colour(0.5,0.6,0.7) mask ($beauty depth-matte 0.9 1.4)) atop $beauty" -o fog.jpg

# A ball, rendered alone, among the blocks of the box by depth.
{
  sed -n '1,/WorldBegin/p' "$scenes/cornell-box/cornell-box.pbrt"
  echo 'LightSource "distant" "point3 from" [ 0.4 1 -1 ] "point3 to" [ 0 0 0 ] "rgb L" [ 1.2 1 .8 ]'
  echo 'Material "diffuse" "rgb reflectance" [ .8 .5 .2 ]'
  echo 'Translate 330 170 215 Shape "sphere" "float radius" 130'
} >"$work/ball.pbrt"
for scene in "$work/ball.pbrt" "$scenes/cornell-box/cornell-box.pbrt"; do
  "$lambert" render --quiet "$scene" --resolution 320x320 --spp 64 --aov depth -o "$work/$(basename "$scene" .pbrt).exr" >/dev/null
done
composite "$work/ball.exr zover $work/cornell-box.exr" -o zover.jpg

# An animated matte, eight frames beside one another.
for f in 0 1 2 3 4 5 6 7; do
  sheet="(($beauty mask (disk([1:60 8:260],160,[1:30 8:240],softness=20))) frame $((f + 1))) over (colour(0.1,0.12,0.15) mask rectangle(0,0,320,320))"
  composite "$sheet" --resolution 320x320 -o "$work/f$f.exr"
done
composite "$work/f0.exr over ($work/f2.exr translate 324 0) over ($work/f4.exr translate 648 0) over ($work/f7.exr translate 972 0)" \
  --resolution 1292x320 -o matte.jpg
