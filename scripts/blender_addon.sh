#!/usr/bin/env bash
# Packs the add-on for Blender into build/surface_mesh_cutting_addon.zip, same sources, same bytes:
#   scripts/blender_addon.sh [PROGRAM]
# PROGRAM: the program unwrap for Linux, to be part of it; scripts/package.sh makes one that runs without installed libraries.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

mkdir -p "$root/build"
program=${1:+$(realpath "$1")}
cd "$root/blender"
python3 - "$root/build/surface_mesh_cutting_addon.zip" "$program" << 'PYTHON'
import platform
import sys
import zipfile
from pathlib import Path


def add(archive, name, path, mode):
    entry = zipfile.ZipInfo(name)  # whose date is always the same
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = mode << 16
    archive.writestr(entry, path.read_bytes())


with zipfile.ZipFile(sys.argv[1], "w") as archive:
    for path in sorted(Path("surface_mesh_cutting_addon").iterdir()):
        if path.suffix in (".py", ".toml"):
            add(archive, str(path), path, 0o644)
    if sys.argv[2]:
        add(archive, f"surface_mesh_cutting_addon/bin/linux-{platform.machine()}/unwrap", Path(sys.argv[2]), 0o755)
PYTHON
echo "add-on   $root/build/surface_mesh_cutting_addon.zip"
