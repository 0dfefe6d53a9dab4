#!/usr/bin/env bash
# Builds everything and runs the tests:
#   scripts/test.sh [--slow] [options of ctest]
# --slow runs those that take minutes, too.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

selection=(--label-exclude '^slow$')
if [ "${1:-}" = --slow ]; then
  selection=()
  shift
fi

"$root/scripts/install_dependencies.sh" build test
"$root/scripts/build.sh"
cd "$root/build"
ctest --output-on-failure --no-tests=error "${selection[@]}" "$@"
