#!/usr/bin/env bash
# Unpacks CGAL's data set (from Debian's package libcgal-demo) into build/data.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

data=$root/build/data
if [ -d "$data" ]; then
  exit 0
fi

mkdir -p "$root/build"
work=$(mktemp -d "$root/build/data.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
fi
download() { apt-get -q -o APT::Sandbox::User= download libcgal-demo; }

echo "Downloading CGAL's data set"
if ! download; then # unknown or outdated package lists
  "${as_root[@]}" apt-get update
  download
fi
dpkg-deb -x libcgal-demo_*.deb .
tar -xzf usr/share/doc/libcgal-dev/data.tar.gz
mv -T data "$data"
