#!/usr/bin/env bash
# Measures all claims of README.md and the manual, and compares both with the results:
#   scripts/measure.sh [--update] [OPTION...]
# Takes less than half an hour on two idle cores. What was measured of the same commit is not measured again, so that calling it again
# goes on where it was; --update writes the results into the texts. The OPTIONs are those of all drivers in
# benchmark/Surface_mesh_cutting: --models, --wild and --graphs FOLDER give the meshes and graphs that do not come with the
# project, --again measures anew, --programs FOLDER takes other programs than those in build/bin.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

update=()
options=()
for word in "$@"; do
  if [ "$word" = --update ]; then update=(--update); else options+=("$word"); fi
done

"$root/scripts/install_dependencies.sh" build corpus evaluation
programs=(unwrap pipeline packing weighted_cuts make_sizes initial_maps connect_random_terminals connect_many_terminals)
if [[ " ${options[*]-} " != *" --programs "* ]] && ! (cd "$root/build/bin" && ls "${programs[@]}") > /dev/null 2>&1; then
  "$root/scripts/build.sh" --target "${programs[@]}"
fi
[ -d "$root/build/data/meshes" ] || "$root/scripts/get_data.sh"
export PYTHONPATH="$root/build/python${PYTHONPATH:+:$PYTHONPATH}"

# A driver tells what it could not measure and why, and the next one runs nevertheless.
for driver in Performance/performance.py Quality/quality.py Robustness/robustness.py; do
  printf '\n== %s ==\n' "$driver"
  "$root/benchmark/Surface_mesh_cutting/$driver" "${options[@]}" || [ $? -eq 3 ]
done
if [ ${#update[@]} -gt 0 ] && [ -f "$root/build/scoreboard/scaling.png" ]; then
  cp "$root/build/scoreboard/scaling.png" "$root/doc/Surface_mesh_cutting/fig/"
fi
exec "$root/scripts/check_claims.py" "${update[@]}"
