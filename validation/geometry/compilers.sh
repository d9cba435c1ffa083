#!/bin/sh
# Do all compilers make the same layers? Builds geometry/ and layer_hashes with g++ and
# clang++ at -O0 to -O3 and compares the output. Usage: compilers.sh BUILD_DIR
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=${1:?usage: compilers.sh BUILD_DIR}
mkdir -p "$out"
# The options of CMakeLists.txt, and -frounding-math, which CGAL requires.
flags="-std=c++20 -w -frounding-math -ffp-contract=off -fno-math-errno -fno-trapping-math"
flags="$flags -I$here $(pkg-config --cflags eigen3)"
failed=0
for compiler in g++ clang++; do
  if ! command -v "$compiler" >/dev/null; then
    echo "blocks: error: no $compiler on this machine (packages-test.txt names it)" >&2
    exit 5
  fi
  for level in -O0 -O1 -O2 -O3; do
    # shellcheck disable=SC2086  # $flags is a list of options.
    (cd "$here" && $compiler $flags $level -o "$out/hashes" \
      validation/geometry/families.cpp validation/geometry/layer_hashes.cpp \
      geometry/decimal.cpp geometry/layer.cpp geometry/merge.cpp \
      geometry/numeric_environment.cpp geometry/polygon.cpp geometry/random.cpp \
      geometry/tiling.cpp geometry/exact/numbers.cpp geometry/exact/quad.cpp -lmpfr -lgmp)
    "$out/hashes" 200 >"$out/found"
    [ -f "$out/first.$$" ] || cp "$out/found" "$out/first.$$"
    if cmp -s "$out/found" "$out/first.$$"; then
      echo "$compiler $level: same bits"
    else
      echo "$compiler $level: DIFFERENT"
      diff "$out/first.$$" "$out/found" || true
      failed=4
    fi
  done
done
rm -f "$out/first.$$"
exit $failed
