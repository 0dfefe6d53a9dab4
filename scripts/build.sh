#!/usr/bin/env bash
# Builds into build/, programs into build/bin/:
#   scripts/build.sh [options of cmake --build, for example --target unwrap]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

"$root/scripts/install_dependencies.sh" build
"$root/scripts/get_data.sh"
cmake -S "$root" -B "$root/build" -DCGAL_DATA_DIR="$root/build/data" --log-level=NOTICE
cmake --build "$root/build" "$@"
