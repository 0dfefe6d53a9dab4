#!/usr/bin/env bash
# Repeats the paper's evaluation, in less than an hour on two cores, and prints which claims hold, and why others do not:
#   scripts/reproduce.sh [MESHES [OUTPUT [...]]]
# MESHES is a folder; default: CGAL's data set. Results go to OUTPUT, by default build/evaluation; calling
# it again goes on where it was. benchmark/evaluation/reproduce.py --help tells the other options.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install_dependencies.sh" build evaluation
programs=(unwrap compare_detectors make_triangulations make_sizes connect_random_terminals)
if ! (cd "$root/build/bin" && ls "${programs[@]}") > /dev/null 2>&1; then
  "$root/scripts/build.sh" --target "${programs[@]}"
fi
if [ $# -eq 0 ]; then
  "$root/scripts/get_data.sh"
fi
meshes=${1:-$root/build/data/meshes}
output=${2:-$root/build/evaluation}
shift $(($# < 2 ? $# : 2))
exec python3 -B "$root/benchmark/evaluation/reproduce.py" "$root/build/bin" "$meshes" "$output" "$@"
