#!/usr/bin/env bash
# usage: docs/guide/probe/make.sh LAMBERT: makes the pictures of docs/guide/probe.md again. Sheets are put together by sheet.py.
set -euo pipefail
lambert=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scenes=$here/../../../scenes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
probe() { "$lambert" probe "$@" >/dev/null; }
sheet() { python3 "$here/sheet.py" "$@"; }
for scene in panorama ball ball-right; do
  "$lambert" render --quiet "$here/$scene.pbrt" -o $scene.pfm >/dev/null
done

# One environment, every layout.
probe convert panorama.pfm --to lat-long --size 128 -o lat-long.pfm
for layout in mirror-ball angular fisheye octahedral equal-area; do
  probe convert panorama.pfm --to $layout --size 192 -o $layout.pfm
done
for layout in vertical-cross horizontal-cross; do probe convert panorama.pfm --to $layout --size 64 -o $layout.pfm; done
sheet sheet-layouts.pfm 4 lat-long.pfm mirror-ball.pfm angular.pfm fisheye.pfm horizontal-cross.pfm vertical-cross.pfm octahedral.pfm equal-area.pfm

# A rendered ball is the panorama.
probe convert ball.pfm --from mirror-ball --reflectivity 0.6 --to lat-long --size 192 -o ball-map.pfm
probe convert panorama.pfm --to lat-long --size 192 -o small.pfm
probe convert ball.pfm --from mirror-ball --reflectivity 0.6 --to mirror-ball --size 192 -o ball-small.pfm
sheet sheet-ball.pfm 3 ball-small.pfm ball-map.pfm small.pfm

# Two balls, one world.
probe assemble ball.pfm ball-right.pfm --angles 0,90 --reflectivity 0.6 --size 192 -o both.pfm
probe convert ball-right.pfm --from mirror-ball --reflectivity 0.6 --to mirror-ball --size 192 -o right-small.pfm
sheet sheet-assemble.pfm 3 ball-small.pfm right-small.pfm both.pfm

# Harmonics and irradiance.
for order in 2 4 8 16; do probe sh panorama.pfm --order $order --size 128 -o sh$order.pfm; done
probe irradiance panorama.pfm --size 128 -o diffuse.pfm
probe irradiance panorama.pfm --method sh --size 128 -o diffuse-sh.pfm
sheet sheet-irradiance.pfm 4 lat-long.pfm sh2.pfm sh4.pfm sh8.pfm sh16.pfm diffuse.pfm diffuse-sh.pfm

# Sky and sun.
probe lights "$scenes/environment/sky.hdr" --sky sky.pfm --pbrt sun.pbrt -o lights.json
probe convert "$scenes/environment/sky.hdr" --to lat-long --size 135 -o whole.pfm
probe convert sky.pfm --to lat-long --size 135 -o without.pfm
grep -v LightSource "$scenes/environment/environment.pbrt" > world.txt
{ sed '/^WorldBegin/q' world.txt; echo 'LightSource "infinite" "string filename" "sky.pfm"'; sed '1,/^WorldBegin/d' world.txt; } > sky.pbrt
{ sed '/^WorldBegin/q' world.txt; cat sun.pbrt; sed '1,/^WorldBegin/d' world.txt; } > sun-only.pbrt
cp "$scenes/environment/sky.hdr" "$scenes/environment/environment.pbrt" .
for scene in sky sun-only environment; do
  "$lambert" render --quiet $scene.pbrt --resolution 240x135 --spp 64 -o lit-$scene.pfm >/dev/null
done
sheet sheet-sun.pfm 5 --one whole.pfm without.pfm lit-sky.pfm lit-sun-only.pfm lit-environment.pfm

# A map that is not turned is only written in another format.
for picture in layouts ball assemble irradiance sun; do probe rotate sheet-$picture.pfm --from lat-long -o "$here/$picture.jpg"; done
