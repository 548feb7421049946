#!/usr/bin/env bash
# usage: docs/guide/polygon/make.sh LAMBERT: makes the pictures of docs/guide/polygon.md again.
set -euo pipefail
lambert=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
draw() { # VERB NAME ARGUMENTS…: check and classify end with 1 where they find what they look for
  "$lambert" polygon "$1" "${@:3}" --svg "$2.svg" >/dev/null || [ $? = 1 ]
}
draw check check faults.geojson
draw classify classify star.wkt
draw classify overlap overlap.wkt
draw contains contains islands.geojson --at 3,3 --at 2,2 --at 2.5,2 --at 9,5 --at 9,6.8 --at 6.5,1
draw pick pick room.geojson --at 5,1.08 --at 3,5
draw clip clip-window room.geojson --window 1,1,9,6.5
draw clip clip-half-planes seven.txt --half-plane 0,0,1,0 --half-plane 5,0,5,1
draw clip clip-line room.geojson --line 0,3.5,10,4.2
draw union union star.wkt ring.txt
draw intersect intersect star.wkt ring.txt
draw difference difference star.wkt ring.txt
draw xor xor star.wkt ring.txt
draw union non-zero star.wkt --rule non-zero
draw trapezoids trapezoids room.geojson
draw trapezoids trapezoids-rotation room.geojson --tie-break rotation --seed 3
draw convex convex room.geojson
draw convex quad quad.txt
draw triangulate triangulate room.geojson
draw strips strips room.geojson
draw fill fill six.txt
"$lambert" polygon extrude gear.wkt --along 0,0,2 -o gear.glb >/dev/null
"$lambert" polygon revolve vase.txt -o vase.glb >/dev/null
for solid in gear vase; do
  "$lambert" render --quiet "$solid.glb" --resolution 320x240 --spp 256 --exposure 0 --tonemap filmic -o "$solid.png" >/dev/null
  rm "$solid.glb"
done
