#!/usr/bin/env bash
# Builds with sanitizers of clang++ and runs tests:
#   scripts/sanitize.sh address [options of ctest]   memory, undefined behavior, assertions; by default all tests of behavior
#   scripts/sanitize.sh program                      the same for the program alone, on unusual meshes
#   scripts/sanitize.sh thread                       races, in what runs in parallel
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}
export ASAN_OPTIONS=detect_stack_use_after_return=1
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=second_deadlock_stack=1

preset=${1:-address}
[ $# -eq 0 ] || shift
targets=()
case $preset in
  address) [ $# -gt 0 ] || set -- --label-exclude '^slow$' --exclude-regex '^merge_check|install|readme' ;;
  program) preset=address
           targets=(--target unwrap)
           set -- --tests-regex '^unwrap_(usage|reading|limits|unusual)$' ;;
  thread)  targets=(--target unwrap test_feature_points test_steiner_tree_parallel)
           set -- --tests-regex '^(unwrap_determinism|execution[ _]+of[ _]+test_(feature_points|steiner_tree_parallel))$' ;;
  *)       echo "usage: $0 address|program|thread [options of ctest]" >&2; exit 2 ;;
esac

"$root/scripts/install_dependencies.sh" build test sanitize
"$root/scripts/get_data.sh"
cd "$root"
cmake --preset "$preset" --log-level=NOTICE
cmake --build "build/$preset" "${targets[@]}"
cd "build/$preset"
ctest --output-on-failure --no-tests=error "$@"
