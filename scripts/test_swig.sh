#!/usr/bin/env bash
# Builds and tests the module for CGAL's SWIG bindings, in build/swig:
#   scripts/test_swig.sh [BINDINGS]
# BINDINGS is a folder with the sources of CGAL/cgal-swig-bindings, which stays as it is. Without it, they come from GitHub.
# They need CGAL 6: on Debian 12, scripts/test_debian.sh trixie swig
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$root/build/swig
sources=${1:-}

if ! command -v swig > /dev/null; then
  echo "SWIG is not installed: the bindings are not tested (scripts/install_dependencies.sh swig)"
  exit 0
fi
if [ -z "$sources" ]; then
  sources=$work/download
  [ -d "$sources" ] || git clone -q --depth 1 https://github.com/CGAL/cgal-swig-bindings "$sources"
fi

# A copy gets the module where the bindings have theirs. They add User_packages by themselves, and run each Python example
# as a test. Dates stay, so that a second build compiles only what has changed.
mkdir -p "$work/tree/SWIG_CGAL/Surface_mesh_cutting" "$work/tree/SWIG_CGAL/User_packages"
cp -r --preserve=timestamps --update "$sources"/{CMakeLists.txt,SWIG_CGAL,cmake,examples} "$work/tree"
cp --preserve=timestamps "$root"/swig/{CMakeLists.txt,CGAL_Surface_mesh_cutting.i} "$work/tree/SWIG_CGAL/Surface_mesh_cutting"
cp --preserve=timestamps "$root/swig/test_surface_mesh_cutting.py" "$work/tree/examples/python"
# shellcheck disable=SC2016 # a variable of CMake
echo 'add_subdirectory("${CMAKE_SOURCE_DIR}/SWIG_CGAL/Surface_mesh_cutting" Surface_mesh_cutting)' \
  > "$work/tree/SWIG_CGAL/User_packages/CMakeLists.txt"

# Before the merge, our named parameters must precede those of CGAL.
cmake -S "$work/tree" -B "$work/build" --log-level=NOTICE -DBUILD_JAVA=OFF -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_STANDARD=17 -DCMAKE_CXX_FLAGS="-I$root/include"
cmake --build "$work/build" --target CGAL_Kernel_python CGAL_Polyhedron_3_python CGAL_Surface_mesh_cutting_python
cd "$work/build"
ctest --output-on-failure --no-tests=error --tests-regex pythontest_test_surface_mesh_cutting
