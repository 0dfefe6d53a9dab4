#!/usr/bin/env bash
# Cuts and unwraps a mesh, by default a cow, and says what is where:
#   scripts/demo.sh [MESH]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/build.sh" --target unwrap

mesh=${1:-$root/build/data/meshes/cow.off}
name=$(basename "${mesh%.*}")
out=$root/build/demo/$name
mkdir -p "$root/build/demo"

status=0
"$root/build/bin/unwrap" "$mesh" -o "$out.uv.obj" --json "$out.json" --svg "$out.svg" --html "$out.html" || status=$?
if [ "$status" -ne 0 ] && [ "$status" -ne 7 ]; then # 7: valid, but a bound was not reached
  exit "$status"
fi

cat << END

mesh with texture coordinates   $out.uv.obj
picture of the layout           $out.svg
measures                        $out.json
page to look at, in a browser   $out.html
END
exit "$status"
