#!/usr/bin/env bash
# Unpacks the headers of CGAL and Eigen of a suite of Debian, for scripts/test_with.sh:
#   scripts/get_cgal.sh SUITE FOLDER [PACKAGE...]      for example: scripts/get_cgal.sh trixie build/debian/trixie
# PACKAGEs besides libcgal-dev and libeigen3-dev, for example libboost1.83-dev. Nothing is installed, and the lists of
# packages of the machine stay as they are. A folder that exists is kept.
set -euo pipefail
if [ $# -lt 2 ]; then
  sed -n 2,5p "${BASH_SOURCE[0]}" >&2
  exit 2
fi
suite=$1
folder=$2
shift 2

if [ -d "$folder" ]; then
  exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/tree"
# From where the machine has its own packages.
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Label: Debian' | head -n 1)
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" > "$work/list"

apt_of_suite() {
  apt-get -q -o "Dir::Etc::SourceList=$work/list" -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$work/lists" \
    -o Dir::State::status=/dev/null -o "Dir::Cache=$work/cache" -o APT::Sandbox::User= "$@"
}
apt_of_suite update
cd "$work"
apt_of_suite download libcgal-dev libeigen3-dev "$@"
for package in *.deb; do
  dpkg-deb -x "$package" tree
done
cd - > /dev/null
mkdir -p "$(dirname "$folder")"
mv -T "$work/tree" "$folder"
