#!/usr/bin/env bash
# Makes the pictures of lab.md again: docs/guide/lab/make.sh PATH_TO_LAMBERT
set -euo pipefail
lambert=$(realpath "$1")
cd "$(dirname "$0")"
for name in nyquist pixel radial-spectra error random-variable quadrature dimensions inversion rejection precision range; do
  "$lambert" lab "$name" -o "$name.svg"
done
for name in detail moire comb jitter patterns spectra best-candidate disk sphere environment noise; do
  "$lambert" lab "$name" -o "$name.png"
done
