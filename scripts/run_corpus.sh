#!/usr/bin/env bash
# Runs unwrap on many meshes and prints a table of outcomes:
#   scripts/run_corpus.sh RESULTS.jsonl MESHES... [--options '--effort fast'] [...]
# MESHES are meshes, folders or lists of meshes; benchmark/Surface_mesh_cutting/Robustness/corpus/run_corpus.py --help tells the rest.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install_dependencies.sh" build corpus
if [ ! -x "$root/build/bin/unwrap" ]; then
  "$root/scripts/build.sh" --target unwrap
fi
exec python3 -B "$root/benchmark/Surface_mesh_cutting/Robustness/corpus/run_corpus.py" "$root/build/bin/unwrap" "$@"
