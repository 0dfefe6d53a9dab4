#!/usr/bin/env bash
# Looks for inputs that make the programs fail, with libFuzzer and sanitizers:
#   scripts/fuzz.sh [mesh|formats|steiner|arguments] [SECONDS] [options of libFuzzer]    (default: mesh 60)
# What it learns stays in build/fuzz/TARGET/inputs; an input that fails is written beside it.
# Looks for command lines and stops after which the program unwrap does not keep what it promises:
#   scripts/fuzz.sh options|stops [SECONDS] [--count N] [--seed N] [--only K]
# Its output names the seed and the numbers of runs that failed, which --seed and --only repeat.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export UBSAN_OPTIONS=print_stacktrace=1

target=${1:-mesh}
seconds=${2:-60}
shift $(($# < 2 ? $# : 2))

case $target in
  options|stops)
    "$root/scripts/install_dependencies.sh" build test
    "$root/scripts/get_data.sh"
    cd "$root"
    cmake --preset default --log-level=NOTICE
    cmake --build build --target unwrap
    exec python3 -B test/unwrap/fuzz_options.py build/bin/unwrap build/data/meshes "$target" --seconds "$seconds" "$@" ;;
esac

"$root/scripts/install_dependencies.sh" build sanitize
"$root/scripts/get_data.sh"
cd "$root"
cmake --preset address --log-level=NOTICE
cmake --build build/address --target "fuzz_$target"

folder=build/fuzz/$target
mkdir -p "$folder/inputs"
python3 -B test/fuzz/make_seeds.py "$target" build/data/meshes "$folder/inputs"
cd "$folder"
"$root/build/address/bin/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=20000 \
  -close_fd_mask=1 -print_final_stats=1 "$@" inputs
