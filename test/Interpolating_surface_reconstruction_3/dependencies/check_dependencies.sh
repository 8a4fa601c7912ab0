#!/usr/bin/env bash
# Usage: check_dependencies.sh COMPILER CGAL_INCLUDE_DIR EIGEN_INCLUDE_DIR [--update]
# Compares package_info/…/dependencies with the CGAL packages whose headers the public headers
# include, or rewrites the file. The $URL line of a header of CGAL names its package.
set -euo pipefail

root=$(cd "$(dirname "$0")/../../.." && pwd)
list=$root/package_info/Interpolating_surface_reconstruction_3/dependencies
included=$(mktemp)
trap 'rm -f "$included"' EXIT

cd "$root"/include
find CGAL -name '*.h' ! -path '*/internal/*' ! -path '*/license/*' | sed 's/.*/#include <&>/' |
  "$1" -std=c++17 -I. -idirafter "$2" -idirafter "$3" -x c++ -M - | tr ' ' '\n' |
  grep "^$2/CGAL/" | xargs sed -n 's#.*\$URL: .*/blob/[^/]*/\([^/]*\)/include/.*#\1#p' |
  { cat; echo Interpolating_surface_reconstruction_3; } | LC_ALL=C sort -u > "$included"

if [ "${4:-}" = --update ]; then
  cp "$included" "$list"
fi
diff "$list" "$included"
