#!/usr/bin/env bash
# Prints what programs cost to compile, in seconds of user time and megabytes, and their ratio to CGAL's ARAP
# parameterizer:
#   benchmark/Surface_mesh_cutting/Performance/compile_cost/compile_cost.sh [REPETITIONS]    (default: 1; the least time counts)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../../.." && pwd)
repetitions=${1:-1}
compiler=${CXX:-g++}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake "-DREADME=$root/README.md" "-DFOLDER=$work" -P "$root/test/install/extract_readme.cmake"

# cost SOURCE [FLAG...]: "seconds megabytes"
cost() {
  for ((i = 0; i < repetitions; ++i)); do
    /usr/bin/time -f '%U %M' -o "$work/cost" "$compiler" -O2 -std=c++17 -DCGAL_EIGEN3_ENABLED "${@:2}" \
      -I"$root/include" -I/usr/include/eigen3 -c "$1" -o "$work/object.o"
    awk '{ print $1, $2 / 1024 }' "$work/cost"
  done | sort -n | head -n 1
}

printf '%-42s %8s %8s %8s\n' program seconds MB ratio
row() {
  read -r seconds megabytes < <(cost "${@:2}")
  reference=${reference:-$seconds}
  awk -v name="$1" -v s="$seconds" -v m="$megabytes" -v r="$reference" \
    'BEGIN { printf "%-42s %8.1f %8.0f %8.2f\n", name, s, m, s / r }'
}
row "CGAL's ARAP parameterizer" "$root/benchmark/Surface_mesh_cutting/Performance/compile_cost/arap.cpp"
row "the program of README.md" "$work/main.cpp"
row "the same with the compiled library" "$work/main.cpp" -DCGAL_SEPARATE_IMPLEMENTATION
row "steiner_tree_example.cpp" "$root/examples/BGL/steiner_tree_example.cpp"
