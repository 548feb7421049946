#!/usr/bin/env bash
# usage: bench/run.sh BUILD_FOLDER [frames.py ARGUMENTS]: every benchmark, one after the other.
set -euo pipefail
build=$1
shift
here=$(dirname "${BASH_SOURCE[0]}")
"$build/bench/bench_micro" --benchmark_min_time=0.2
"$build/bench/bench_rays"
python3 "$here/frames/frames.py" "$build/bin/lambert" "$@"
