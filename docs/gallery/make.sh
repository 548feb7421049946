#!/usr/bin/env bash
# make.sh BINARY [--png FOLDER] [FILE…]: renders the pictures of pictures.json and those of the guides
# (or the FILEs named, of pictures.json) and writes README.md.
set -euo pipefail
exec python3 "$(dirname "${BASH_SOURCE[0]}")/make.py" "$@"
