#!/usr/bin/env bash
# Compares this program with others on a folder of meshes, measured alike, and writes tables and a page into build/compare/results:
#   scripts/compare.sh FOLDER... [--output FOLDER] [--only NAME,...] [--time-limit SECONDS]
# benchmark/compare/programs.txt is the table of commands. Calling it again goes on where it was.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install_dependencies.sh" build compare
[ -x "$root/build/bin/unwrap" ] || "$root/scripts/build.sh" --target unwrap
exec /usr/bin/python3 -B "$root/benchmark/compare/compare.py" "$@"
