#!/usr/bin/env bash
# Builds the manual into build/doc/. A warning of doxygen is a failure.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export ROOT=$root # read by the Doxyfile

"$root/scripts/install_dependencies.sh" doc
rm -rf "$root/build/doc"
mkdir -p "$root/build/doc"
cd "$root"
doxygen doc/Doxyfile.standalone

# Formulas show without a network: the manual holds the parts of MathJax that draw TeX as SVG.
mathjax=/usr/share/javascript/mathjax
mkdir build/doc/html/mathjax
(cd "$mathjax" && cp --parents --recursive --dereference \
  MathJax.js extensions jax/element jax/input/TeX jax/output/SVG/*.js jax/output/SVG/autoload jax/output/SVG/fonts/TeX \
  "$root/build/doc/html/mathjax")

python3 doc/check_links.py build/doc/html
echo "manual   $root/build/doc/html/index.html"
