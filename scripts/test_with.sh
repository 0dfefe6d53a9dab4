#!/usr/bin/env bash
# Builds and tests with other headers of CGAL and Eigen than those of the machine, in build/NAME_OF_TREE:
#   scripts/test_with.sh CGAL_TREE [EIGEN_TREE] [--target TARGET...] [options of ctest]
# scripts/get_cgal.sh makes such trees. Eigen is that of the tree of CGAL, or of the machine if there is none in it.
# Without --target, everything is built; what ctest runs without options are all tests but those that take minutes.
# Nothing is optimized much, since here compiling takes longer than running.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

# folder_of TREE FILE: the folder below TREE that holds the file
folder_of() { find "$1" -name "$2" -printf '%h\n' -quit; }

if [ $# -eq 0 ] || [ -z "$(folder_of "$1" CGALConfig.cmake)" ]; then
  sed -n 2,6p "${BASH_SOURCE[0]}" >&2
  exit 2
fi
cgal=$(realpath "$1")
eigen=$cgal
shift
if [ $# -gt 0 ] && [[ $1 != -* ]]; then
  eigen=$(realpath "$1")
  shift
fi
targets=()
if [ "${1:-}" = --target ]; then
  targets=("$1")
  shift
  while [ $# -gt 0 ] && [[ $1 != -* ]]; do
    targets+=("$1")
    shift
  done
fi
[ $# -gt 0 ] || set -- --label-exclude '^slow$'

"$root/scripts/install_dependencies.sh" build test
"$root/scripts/get_data.sh"
build=$root/build/$(basename "$cgal")
choice=("-DCGAL_DIR=$(folder_of "$cgal" CGALConfig.cmake)")
eigen_folder=$(folder_of "$eigen" Eigen3Config.cmake)
[ -z "$eigen_folder" ] || choice+=("-DEigen3_DIR=$eigen_folder")
cmake -S "$root" -B "$build" -G Ninja --log-level=STATUS "${choice[@]}" -DCGAL_DATA_DIR="$root/build/data" \
  -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_UNITY_BUILD=ON | grep "Using"
cmake --build "$build" "${targets[@]}"
cd "$build"
ctest --output-on-failure --no-tests=error "$@"
