#!/usr/bin/env bash
# Installs what is missing, from Debian; from npm, the validator of glTF, which the tests use where it is there, and xatlas, with
# which results are compared:
#   scripts/install_dependencies.sh [build|test|python|swig|lab|corpus|evaluation|sanitize|doc|figures|blender|validator|compare]...    (default: build test)
set -euo pipefail

if [ $# -eq 0 ]; then
  set -- build test
fi

wanted=()
packages=() # of npm, each with the folder in build/ where it is installed, since npm removes others there
for purpose in "$@"; do
  case $purpose in
    build) wanted+=(g++ cmake make ninja-build libcgal-dev libeigen3-dev libboost-dev
                    libtbb-dev libsuitesparse-dev libmetis-dev libcli11-dev nlohmann-json3-dev libpng-dev libjs-three) ;;
    test)  wanted+=(libopenmesh-dev python3 python3-numpy python3-scipy chromium assimp-utils) ;;
    python) wanted+=(python3-dev pybind11-dev python3-numpy python3-pytest python3-matplotlib
                     python3-pip python3-setuptools python3-wheel python3-venv) ;;
    swig)  wanted+=(g++ cmake make libcgal-dev libeigen3-dev libboost-dev libtbb-dev swig python3-dev git ca-certificates) ;;
    lab)   wanted+=(g++ cmake ninja-build libcgal-dev libcgal-qt6-dev libcgal-demo libeigen3-dev libboost-dev libtbb-dev
                    qt6-base-dev qt6-declarative-dev qt6-svg-dev libgl1-mesa-dri xvfb xauth) ;;
    corpus) wanted+=(parallel python3) ;;
    evaluation) wanted+=(python3 gnuplot-nox) ;;
    sanitize) wanted+=(clang libclang-rt-dev python3) ;;
    doc)   wanted+=(doxygen libjs-mathjax python3) ;;
    figures) wanted+=(povray python3) ;;
    blender) wanted+=(blender xvfb xauth libgl1-mesa-dri python3) ;;
    validator) packages+=(gltf-validator@2.0.0-dev.3.10 .) ;;
    compare) wanted+=(python3-numpy python3-scipy blender)
             packages+=(watlas@1.0.1 compare) ;;
    *)     echo "usage: $0 [build|test|python|swig|lab|corpus|evaluation|sanitize|doc|figures|blender|validator|compare]..." >&2; exit 2 ;;
  esac
done

install_from_debian() {
  if ! command -v dpkg-query apt-get > /dev/null; then
    echo "Not a Debian system; needed are the equivalents of: $*" >&2
    return
  fi
  local installed package missing=() as_root=()
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2> /dev/null || true)
  for package in "$@"; do
    grep -qxF "$package installed" <<< "$installed" || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return
  fi
  if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  "${as_root[@]}" apt-get update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "${missing[@]}"
}

# install_from_npm PACKAGE FOLDER ...
install_from_npm() {
  local build
  build=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/build
  while [ $# -gt 0 ]; do
    if [ ! -d "$build/$2/node_modules/${1%@*}" ]; then
      mkdir -p "$build/$2"
      npm install --no-save --no-audit --no-fund --prefix "$build/$2" "$1" || echo "npm cannot be reached: ${1%@*} is not there" >&2
    fi
    shift 2
  done
}

if [ ${#packages[@]} -gt 0 ] && ! command -v npm > /dev/null; then
  wanted+=(nodejs npm) # others than Debian's bring their own npm
fi
if [ ${#wanted[@]} -gt 0 ]; then
  install_from_debian "${wanted[@]}"
fi
install_from_npm "${packages[@]}"
