#!/usr/bin/env bash
# Packs the add-on for Blender into build/surface_mesh_cutting_addon.zip: same sources, same bytes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

mkdir -p "$root/build"
cd "$root/blender"
python3 - "$root/build/surface_mesh_cutting_addon.zip" << 'PYTHON'
import sys
import zipfile
from pathlib import Path

with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as archive:
    for path in sorted(Path("surface_mesh_cutting_addon").iterdir()):
        if path.suffix in (".py", ".toml"):
            entry = zipfile.ZipInfo(str(path))  # whose date is always the same
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, path.read_bytes())
PYTHON
echo "add-on   $root/build/surface_mesh_cutting_addon.zip"
