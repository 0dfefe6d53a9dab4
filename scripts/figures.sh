#!/usr/bin/env bash
# Makes the figures of the manual in doc/Surface_mesh_cutting/fig from results on CGAL's data set:
#   scripts/figures.sh [FIGURE...]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install_dependencies.sh" figures python
"$root/scripts/build.sh" --target unwrap surface_mesh_cutting_python
sources=$root/doc/Surface_mesh_cutting/fig_src
work=$root/build/figures
mkdir -p "$work"
ln -sf ../bin/unwrap "$work/unwrap"
for program in candidates handle_loops; do
  g++ -O2 -std=c++17 -DNDEBUG -DCGAL_EIGEN3_ENABLED -I"$root/include" -I/usr/include/eigen3 \
    "$sources/$program.cpp" -o "$work/$program" -lgmp -lmpfr
done
# The figure of the Python module is drawn by its example.
others=()
for figure in "$@"; do
  [ "$figure" = python ] || others+=("$figure")
done
if [ $# -ne ${#others[@]} ] || [ $# -eq 0 ]; then
  PYTHONPATH="$root/build/python" /usr/bin/python3 -B "$root/python/example/unwrap_and_draw.py" \
    "$root/build/data/meshes/bear.off" "$root/doc/Surface_mesh_cutting/fig/python.png"
fi
if [ $# -eq 0 ] || [ ${#others[@]} -gt 0 ]; then
  python3 "$sources/figures.py" "$work" "$root/build/data/meshes" "$work" \
    "$root/doc/Surface_mesh_cutting/fig" "${others[@]}"
fi
