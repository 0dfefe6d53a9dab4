#!/usr/bin/env bash
# Tries the last commit on another suite of Debian, in a chroot in build/chroot; needs root and debootstrap:
#   scripts/test_debian.sh SUITE [demo|python|blender|test|swig|lab]...      for example: scripts/test_debian.sh trixie
# demo and test: the two commands of README; python: its Python module, with tests; blender: the add-on in the suite's Blender;
# swig: the module of CGAL's SWIG bindings; lab: the plugin of CGAL Lab. Without words: demo, python and
# blender. A chroot that exists is used again. Packages come from where the machine has its own.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [ $# -eq 0 ] || [ "$(id -u)" -ne 0 ] || ! command -v debootstrap > /dev/null; then
  sed -n 2,6p "${BASH_SOURCE[0]}" >&2
  exit 2
fi
suite=$1
shift
[ $# -gt 0 ] || set -- demo python blender

chroot=$root/build/chroot/$suite
if [ ! -d "$chroot" ]; then
  mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Label: Debian' | head -n 1)
  mkdir -p "$root/build/chroot"
  debootstrap --variant=minbase "$suite" "$chroot.part" "$mirror"
  echo force-unsafe-io > "$chroot.part/etc/dpkg/dpkg.cfg.d/unsafe-io" # faster, and nothing in it is of value
  mv -T "$chroot.part" "$chroot"
fi

# Git keeps the dates of files that are the same, so that a second build compiles only what has changed.
checkout=$chroot/srv/checkout
[ -d "$checkout" ] || git init -q "$checkout"
git -C "$checkout" fetch -q --depth 1 "file://$root" HEAD
git -C "$checkout" checkout -q --force --detach FETCH_HEAD

# inside COMMAND: in the checkout, with mounts that end with the command
inside() {
  unshare --mount bash -euc '
    for folder in dev proc sys; do
      mount --rbind "/$folder" "$1/$folder"
    done
    exec chroot "$1" /usr/bin/env -i HOME=/srv PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
      CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" bash -euc "cd /srv/checkout && $2"' _ "$chroot" "$1"
}

versions() { inside "dpkg-query -W -f '\${Package} \${Version}\n' $* 2> /dev/null" || true; }

for step in "$@"; do
  printf '\n== %s: %s ==\n' "$suite" "$step"
  case $step in
    demo) inside "scripts/demo.sh" ;;
    test) inside "scripts/test.sh" ;;
    python)
      inside "scripts/install_dependencies.sh build python &&
        /usr/bin/python3 -m venv --system-site-packages build/env &&
        build/env/bin/pip install --no-build-isolation ./python &&
        build/env/bin/python -m pytest -q -p no:cacheprovider python/test" ;;
    blender) inside "scripts/install_dependencies.sh blender && scripts/test_blender.sh" ;;
    swig) inside "scripts/install_dependencies.sh swig && scripts/test_swig.sh" ;;
    lab) inside "scripts/install_dependencies.sh lab && scripts/test_lab.sh" ;;
    *) echo "unknown: $step" >&2; exit 2 ;;
  esac
done
printf '\n'
versions g++ cmake libcgal-dev libeigen3-dev libboost-dev python3 python3-numpy pybind11-dev blender
