#!/usr/bin/env bash
# Packs what users install into build/packages/, and tries each package where nothing else of the project is:
#   scripts/package.sh [program|library|wheel]...    (default: all)
# program: the program unwrap for Linux, which needs no library but those of C, as unwrap-VERSION-linux-MACHINE.tar.gz, and
#          the add-on for Blender with it, as surface_mesh_cutting_addon.zip. It computes with one thread. Takes minutes.
# library: headers and compiled library, as a package for Debian.
# wheel:   the Python module, for the Python and with the libraries of this system.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages=$root/build/packages
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
if command -v ninja > /dev/null; then
  export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}
fi

pack_program() {
  local static=$root/build/static name folder
  cmake -S "$root" -B "$static" --log-level=NOTICE -DSURFACE_MESH_CUTTING_PORTABLE=ON -DBUILD_TESTING=OFF \
    -DSURFACE_MESH_CUTTING_WITH_PYTHON=OFF -DSURFACE_MESH_CUTTING_WITH_PRECOMPILED_HEADERS=OFF -DCMAKE_UNITY_BUILD=ON
  cmake --build "$static" --target unwrap
  name=unwrap-$("$static/bin/unwrap" --version | cut -d' ' -f2)-linux-$(uname -m)
  folder=$packages/$name
  rm -rf "$folder"
  mkdir -p "$folder"
  strip -o "$folder/unwrap" "$static/bin/unwrap"
  cp "$root/examples/Surface_mesh_cutting/unwrap/README.md" "$root/LICENSE" "$root/LICENSE.LGPL" "$folder"
  # The licenses of what the program holds.
  local package
  for package in libcgal-dev libeigen3-dev libboost-dev libcli11-dev nlohmann-json3-dev libpng-dev zlib1g-dev \
                 libgmp-dev libmpfr-dev libjs-three "libstdc++-$(g++ -dumpversion)-dev"; do
    if [ -e "/usr/share/doc/$package/copyright" ]; then
      mkdir -p "$folder/licenses"
      cp -L "/usr/share/doc/$package/copyright" "$folder/licenses/$package.txt"
    fi
  done
  tar -C "$packages" --sort=name --owner=0 --group=0 --numeric-owner -czf "$packages/$name.tar.gz" "$name"
  "$root/scripts/blender_addon.sh" "$folder/unwrap"
  mv "$root/build/surface_mesh_cutting_addon.zip" "$packages"
  rm -r "$folder"
}

pack_library() {
  "$root/scripts/build.sh" --target Surface_mesh_cutting
  rm -f "$packages"/libsurface-mesh-cutting-dev_*.deb
  cpack --config "$root/build/CPackConfig.cmake" -G DEB -B "$packages"
  rm -rf "$packages/_CPack_Packages"
}

pack_wheel() {
  rm -f "$packages"/surface_mesh_cutting-*.whl
  /usr/bin/python3 -m pip wheel --quiet --no-deps --no-build-isolation --no-index --wheel-dir "$packages" "$root/python"
}

if [ $# -eq 0 ]; then
  set -- program library wheel
fi
"$root/scripts/install_dependencies.sh" build python
mkdir -p "$packages"
for kind in "$@"; do
  case $kind in
    program|library|wheel) "pack_$kind" ;;
    *) echo "usage: $0 [program|library|wheel]..." >&2; exit 2 ;;
  esac
  /usr/bin/python3 -B "$root/test/install/test_packages.py" "$packages" "$kind"
done
ls -l "$packages"
