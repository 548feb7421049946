#!/bin/sh
# Makes the pictures of ../denoise.md: docs/guide/denoise/make.sh build/release/bin/lambert
set -e
lambert=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
python3 -c "import sys; sys.path.insert(0, '$here/../../../bench/denoise'); import boxes; boxes.write('$work')"
dof="$here/../../../scenes/depth-of-field/depth-of-field.pbrt"
for shot in "glossy $work/glossy.pbrt 256x256" "textured $work/textured.pbrt 256x256" "depth-of-field $dof 384x216"; do
  set -- $shot
  common="render $2 --resolution $3 --quiet --exposure 1"
  $lambert $common --spp 16 --aov denoising -o "$work/$1.exr" -o "$here/$1-noisy.jpg"
  for method in bilateral nlm nfor; do
    $lambert denoise "$work/$1.exr" --method $method --exposure 1 -o "$here/$1-$method.jpg"
  done
  $lambert $common --spp 512 -o "$here/$1-reference.jpg"
done
