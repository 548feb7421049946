#!/usr/bin/env bash
# usage: tests/fuzz/run.sh BUILD_FOLDER SECONDS: shares SECONDS among the readers and the booleans of polygons, starting from tests/corpora.
set -euo pipefail
build=$1 seconds=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
readers=(gltf pbrt obj ply image png polygon_file composite boolean)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for reader in "${readers[@]}"; do
  mkdir -p "$work/$reader"
  echo "fuzz $reader"
  corpus=${reader%_file}
  [ "$reader" != png ] || corpus=image
  # Outside of the sources: what the fuzzer finds interesting is not ours to keep; crashes are kept in the build folder.
  if ! "$build/tests/fuzz/fuzz_$reader" -max_total_time=$((seconds / ${#readers[@]})) -rss_limit_mb=2048 -timeout=10 -max_len=65536 \
    -print_final_stats=1 -artifact_prefix="$build/" "$work/$reader" "$here/../corpora/$corpus" >"$work/log" 2>&1; then
    tail -n 60 "$work/log"
    exit 1
  fi
  grep "number_of_executed_units" "$work/log"
done
