#!/usr/bin/env bash
# usage: docs/guide/tonemap/make.sh LAMBERT: makes the pictures of docs/guide/tonemap.md again.
set -euo pipefail
lambert=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
scenes=../../../scenes
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
"$lambert" render $scenes/environment/environment.pbrt --resolution 960x540 --spp 128 --set clamp=3 --quiet -o "$work/sunset.exr" >/dev/null
map() { "$lambert" tonemap "$work/sunset.exr" "$@" >/dev/null; }

map --montage --tile-width 300 --exposure auto -o montage.jpg
for name in linear darkest-range darkest-pixels reinhard photographic photographic-local reinhard-devlin drago durand fattal mertens \
  filmic aces agx; do
  exposure=0
  case $name in linear | reinhard | filmic | aces | agx) exposure=auto+1 ;; esac
  map --operator $name --exposure $exposure -o "$work/$name.exr"
  "$lambert" tonemap "$work/$name.exr" --operator linear --montage --tile-width 400 -o "$name.jpg" >/dev/null
done
python3 craik_o_brien.py "$work/craik.pfm"
"$lambert" tonemap "$work/craik.pfm" --operator linear -o craik-o-brien.png >/dev/null
