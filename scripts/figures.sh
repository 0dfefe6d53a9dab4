#!/usr/bin/env bash
# Makes the figures of the manual in doc/Surface_mesh_cutting/fig from results on CGAL's data set:
#   scripts/figures.sh [FIGURE...]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install_dependencies.sh" figures
"$root/scripts/build.sh" --target unwrap
sources=$root/doc/Surface_mesh_cutting/fig_src
work=$root/build/figures
mkdir -p "$work"
ln -sf ../bin/unwrap "$work/unwrap"
for program in candidates handle_loops; do
  g++ -O2 -std=c++17 -DNDEBUG -DCGAL_EIGEN3_ENABLED -I"$root/include" -I/usr/include/eigen3 \
    "$sources/$program.cpp" -o "$work/$program" -lgmp -lmpfr
done
python3 "$sources/figures.py" "$work" "$root/build/data/meshes" "$work" \
  "$root/doc/Surface_mesh_cutting/fig" "$@"
