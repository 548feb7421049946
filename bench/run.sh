#!/usr/bin/env bash
# usage: bench/run.sh BUILD_FOLDER [frames.py ARGUMENTS]: every benchmark, one after the other; --plots FOLDER draws.
# What needs another program to stand beside says so and is passed over where that is missing.
set -euo pipefail
build=$1
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
lambert=$build/bin/lambert
plots=
for ((i = 1; i < $#; ++i)); do
  if [[ ${!i} == --plots ]]; then next=$((i + 1)) plots=${!next}; fi
done
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# run SCRIPT [PEER ...] -- ARGUMENTS
run() {
  local script=$1
  shift
  echo "== $script"
  while [[ $1 != -- ]]; do
    if ! command -v "$1" >/dev/null; then
      echo "passed over: $1 is not installed"
      return
    fi
    shift
  done
  shift
  python3 "$here/$script" "$@"
}
# --plot and FOLDER, or the file $1 in it, when there are to be plots.
plot() { if [[ -n $plots ]]; then printf '%s\n' --plot "$plots${1:+/$1}"; fi; }

"$build/bench/bench_micro" --benchmark_min_time=0.2
"$build/bench/bench_rays"
atlas=$here/../../shared/data/polygons/world-atlas/countries-110m.json
"$build/bench/polygon/bench_booleans" --tsv "$work/times.tsv" $([[ -f $atlas ]] && echo --countries "$atlas")
if [[ -n $plots ]]; then run polygon/plot.py -- "$work/times.tsv" "$plots"; fi
"$build/bench/filter/bench_lookups"
run filter/resize.py oiiotool -- "$lambert"
run composite/over.py oiiotool -- "$lambert"
"$build/bench/probe/bench_irradiance" >"$work/irradiance.tsv"
cat "$work/irradiance.tsv"
if [[ -n $plots ]]; then run probe/plot.py -- "$work/irradiance.tsv" "$plots"; fi
run probe/convert.py -- "$lambert"
run tonemap/run.py pfstmo_drago03 pfsinexr -- "$lambert" $(plot tone-operators.svg)
if command -v pfshdrcalibrate >/dev/null; then
  "$lambert" render "$here/../scenes/instances/instances.pbrt" --resolution 2048x1365 --spp 4 --quiet -o "$work/map.exr"
fi
run hdr/merge.py pfshdrcalibrate -- "$lambert" "$work/map.exr" $(plot)
run denoise/denoise.py -- "$lambert" $(plot denoise.svg)
run frames/frames.py -- "$lambert" "$@"
