#!/usr/bin/env bash
# usage: bench/run.sh BUILD_FOLDER [frames.py ARGUMENTS]: every benchmark, one after the other; --plots FOLDER draws.
set -euo pipefail
build=$1
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
plots=
for ((i = 1; i < $#; ++i)); do
  if [[ ${!i} == --plots ]]; then next=$((i + 1)) plots=${!next}; fi
done
"$build/bench/bench_micro" --benchmark_min_time=0.2
"$build/bench/bench_rays"
times=$(mktemp)
trap 'rm -f "$times"' EXIT
atlas=$here/../../shared/data/polygons/world-atlas/countries-110m.json
"$build/bench/polygon/bench_booleans" --tsv "$times" $([[ -f $atlas ]] && echo --countries "$atlas")
if [[ -n $plots ]]; then python3 "$here/polygon/plot.py" "$times" "$plots"; fi
python3 "$here/frames/frames.py" "$build/bin/lambert" "$@"
