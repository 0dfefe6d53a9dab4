#!/usr/bin/env bash
# Tests the add-on in Blender, where that is installed (scripts/install_dependencies.sh blender):
#   scripts/test_blender.sh [WORD... | --picture]
# With words, only the tests with one of them in their name, and none that needs a window.
# --picture renders the figure of the manual instead.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if ! { command -v blender && command -v xvfb-run; } > /dev/null; then
  echo "Blender is not installed: its add-on is not tested (scripts/install_dependencies.sh blender)"
  exit 0
fi
"$root/scripts/build.sh" --target unwrap
"$root/scripts/blender_addon.sh"

# The user's own add-ons and preferences stay out of it.
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export BLENDER_USER_SCRIPTS=$home BLENDER_USER_CONFIG=$home/config
files=("$root/build/surface_mesh_cutting_addon.zip" "$root/build/bin/unwrap")

# run SCRIPT [ARGUMENT...]: in Blender without a window
run() {
  blender --background --factory-startup --python-exit-code 1 --python "$1" -- "${files[@]}" "${@:2}"
}

if [ "${1:-}" = --picture ]; then
  run "$root/doc/Surface_mesh_cutting/fig_src/blender_scene.py" "$root/doc/Surface_mesh_cutting/fig/blender.png"
  exit 0
fi
run "$root/blender/test/run_tests.py" "$@"
if [ $# -eq 0 ]; then
  timeout 300 xvfb-run --auto-servernum --server-args "-screen 0 1024x768x24" \
    blender --factory-startup --enable-event-simulate --window-geometry 0 0 1024 768 --no-window-focus \
    --python-exit-code 1 --python "$root/blender/test/window.py" -- "${files[@]}"
fi
