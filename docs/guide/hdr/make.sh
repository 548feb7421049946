#!/usr/bin/env bash
# usage: docs/guide/hdr/make.sh LAMBERT: makes the pictures of docs/guide/hdr.md again, from the scene in scenes/.
set -euo pipefail
lambert=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
here=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
scene=$here/../../../scenes/many-lights/many-lights.pbrt
"$lambert" render "$scene" --quiet --resolution 400x224 --spp 64 -o map.exr >/dev/null
show() { "$lambert" hdr expose "$1" --time "$2" -o "$here/$3" >/dev/null; } # MAP TIME PICTURE: as sRGB shows it

# The stack: photographs by a film camera, with noise, from the hand.
camera=(--response film --full-well 20000 --read-noise 8)
"$lambert" hdr expose map.exr --bracket -5..3:2 --time 1 "${camera[@]}" -o 'shot_{}.png' --list shots.txt >/dev/null
"$lambert" hdr expose map.exr --bracket -5..3:2 --time 1 "${camera[@]}" -o 'shot_{}.jpg' >/dev/null
for i in 0 2 4; do cp "shot_0$i.jpg" "$here/shot-$i.jpg"; done
"$lambert" hdr merge shots.txt -o merged.exr --plot "$here/response.svg" -q >/dev/null
show merged.exr 0.06 merged-low.jpg
show merged.exr 0.6 merged-middle.jpg
show merged.exr 6 merged-high.jpg

# From the hand.
"$lambert" hdr expose map.exr --bracket -5..3:2 "${camera[@]}" --shake 7 --turn 0.4 --seed 2 -o 'hand_{}.png' --list hand.txt >/dev/null
"$lambert" hdr merge hand.txt -o loose.exr -q --align none --ghosts off --response film >/dev/null
"$lambert" hdr merge hand.txt -o firm.exr -q --ghosts off --response film >/dev/null
show loose.exr 0.6 hand-none.jpg
show firm.exr 0.6 hand-rigid.jpg

# A ball that is elsewhere in each photograph.
moment() { # NUMBER X
  { sed '/^WorldBegin/q' "$scene"; cat <<BALL
AttributeBegin
  Material "diffuse" "rgb reflectance" [ .75 .2 .1 ]
  Translate $2 1.1 -6.2
  Shape "sphere" "float radius" 1.1
AttributeEnd
BALL
    sed '1,/^WorldBegin/d' "$scene"; } >"$(dirname "$scene")/.moment.pbrt"
  "$lambert" render "$(dirname "$scene")/.moment.pbrt" --quiet --resolution 400x224 --spp 48 -o "moment$1.exr" >/dev/null
  rm "$(dirname "$scene")/.moment.pbrt"
}
: >ghost.txt
for i in 0 1 2 3; do
  moment $i "$((i * 2 - 3))"
  time=$(awk -v i=$i 'BEGIN { print 0.1 * 4 ^ i }')
  "$lambert" hdr expose "moment$i.exr" --time "$time" --seed $i "${camera[@]}" -o "ghost_$i.png" >/dev/null
  echo "ghost_$i.png $time" >>ghost.txt
done
"$lambert" hdr merge ghost.txt -o ghosts.exr -q --align none --ghosts off --response film >/dev/null
"$lambert" hdr merge ghost.txt -o laid.exr -q --align none --response film >/dev/null
show ghosts.exr 0.6 ghosts-off.jpg
show laid.exr 0.6 ghosts-auto.jpg
