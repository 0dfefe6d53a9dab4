#!/usr/bin/env bash
# Builds into build/, programs into build/bin/:
#   scripts/build.sh [options of cmake --build, for example --target unwrap]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

"$root/scripts/install_dependencies.sh" build
"$root/scripts/get_data.sh"
# Ninja compiles several targets at the same time, Make one after the other. An existing folder keeps what it has.
if command -v ninja > /dev/null; then
  export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}
fi
cmake -S "$root" -B "$root/build" -DCGAL_DATA_DIR="$root/build/data" --log-level=NOTICE
cmake --build "$root/build" "$@"
