#!/usr/bin/env bash
# Installs from Debian what is missing:
#   scripts/install_dependencies.sh [build|test|python|corpus|cluster|evaluation|sanitize|doc|figures|blender|ci]...    (default: build test)
set -euo pipefail

if [ $# -eq 0 ]; then
  set -- build test
fi

wanted=()
for purpose in "$@"; do
  case $purpose in
    build) wanted+=(g++ cmake make ninja-build libcgal-dev libeigen3-dev libboost-dev
                    libtbb-dev libsuitesparse-dev libmetis-dev libcli11-dev nlohmann-json3-dev libpng-dev libtinygltf-dev libjs-three) ;;
    test)  wanted+=(libopenmesh-dev python3 chromium) ;;
    python) wanted+=(python3-dev pybind11-dev python3-numpy python3-pytest python3-matplotlib
                     python3-pip python3-setuptools python3-wheel python3-venv) ;;
    corpus) wanted+=(parallel python3) ;;
    cluster) wanted+=(parallel python3 slurmctld slurmd slurm-client munge openssh-client openssh-server) ;;
    evaluation) wanted+=(python3 gnuplot-nox) ;;
    sanitize) wanted+=(clang libclang-rt-14-dev python3) ;;
    doc)   wanted+=(doxygen libjs-mathjax python3) ;;
    figures) wanted+=(povray python3) ;;
    blender) wanted+=(blender xvfb xauth libgl1-mesa-dri python3) ;;
    ci)    wanted+=(clang) ;;
    *)     echo "usage: $0 [build|test|python|corpus|cluster|evaluation|sanitize|doc|figures|blender|ci]..." >&2; exit 2 ;;
  esac
done

if ! command -v dpkg-query apt-get > /dev/null; then
  echo "Not a Debian system; needed are the equivalents of: ${wanted[*]}" >&2
  exit 0
fi

installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2> /dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "$package installed" <<< "$installed" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --no-install-recommends "${missing[@]}"
