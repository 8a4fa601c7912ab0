#!/usr/bin/env bash
# Usage: check_headers.sh COMPILER [OPTION...]
# Compiles every header alone, included twice: it includes what it uses, and its guard works. Internal ones share the
# precompiled headers of other libraries, which take most of the time: they may lack those, but none of the package.
set -euo pipefail

cd "$(dirname "$0")/../../../include"
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
export compile="$* -std=c++17 -DCGAL_EIGEN3_ENABLED -I."
export others=$scratch/others.h

# Some are for certain versions of the libraries.
headers=$(find CGAL -name '*.h' | LC_ALL=C sort)
sed -n 's/^ *# *include <\(.*\)>.*/\1/p' $headers | LC_ALL=C sort -u | grep -vxFf <(echo "$headers") |
  sed 's/.*/#if __has_include(<&>)\n#include <&>\n#endif/' > "$others"
# Only some versions of clang have the option.
$compile -fpch-instantiate-templates -x c++-header "$others" -o "$others.gch" 2> /dev/null ||
  $compile -x c++-header "$others" -o "$others.gch"

check_header() {
  local known=
  [[ $1 != */internal/* ]] || known="-include $others"
  printf '#include <%s>\n#include <%s>\n' "$1" "$1" |
    $compile -fsyntax-only $known -x c++ - || { echo "$1 does not compile alone"; return 1; }
}
export -f check_header

xargs -P 2 -I HEADER bash -c 'check_header HEADER' <<< "$headers"
