#!/usr/bin/env bash
# Builds the plugin and what it needs of CGAL Lab in build/lab, and tests it there without a screen:
#   scripts/test_lab.sh [LAB]
# LAB is the folder demo/Lab of CGAL 6, which stays as it is. Without it, it is that of Debian's package libcgal-demo.
# On Debian 12, use scripts/test_debian.sh trixie lab. Pictures of the maps are left in build/lab.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$root/build/lab
archive=/usr/share/doc/libcgal-dev/demo.tar.gz

mkdir -p "$work"
if [ $# -gt 0 ]; then
  cp -r --preserve=timestamps --update -T "$1" "$work/Lab"
elif [ -f "$archive" ]; then
  tar -xzf "$archive" -C "$work" --strip-components=1 demo/Lab
else
  echo "There is no $archive: the plugin is not tested (scripts/install_dependencies.sh lab)"
  exit 0
fi

# Lab adds each folder next to its plugins.
ln -sfn "$root/demo/Lab/Plugins/Surface_mesh_cutting" "$work/Lab/Plugins/Surface_mesh_cutting"
ln -sfn "$root/test/lab" "$work/Lab/Plugins/Surface_mesh_cutting_test"

# Before the merge, our named parameters must precede those of CGAL. Compiling takes longer than running.
cmake -S "$work/Lab" -B "$work/build" -G Ninja --log-level=WARNING -Wno-dev -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS="-I$root/include" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG"
cmake --build "$work/build" --target off_plugin parameterization_plugin selection_plugin surface_mesh_cutting_plugin \
  test_cutting_plugin

# Lab draws in a window, and so needs an X server. The user's settings stay out of it. The mesh is one that ARAP can map: where its
# start has flips, as on most animals, CGAL 6.0 cannot solve a system.
"$root/scripts/get_data.sh"
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export XDG_CONFIG_HOME=$home QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1
timeout 300 xvfb-run --auto-servernum --server-args "-screen 0 1280x1024x24" \
  "$work/build/test_cutting_plugin" "$root/build/data/meshes/knot1.off" "$work"
