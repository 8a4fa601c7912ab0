#!/usr/bin/env bash
# Usage: check_headers.sh COMPILER [OPTION...]
# Compiles every header alone, included twice: it includes what it uses, and its guard works.
set -euo pipefail

cd "$(dirname "$0")/../../../include"
export compiler="$*"

check_header() {
  printf '#include <%s>\n#include <%s>\n' "$1" "$1" |
    $compiler -std=c++17 -fsyntax-only -DCGAL_EIGEN3_ENABLED -I. -x c++ - || { echo "$1 does not compile alone"; return 1; }
}
export -f check_header

find CGAL -name '*.h' | LC_ALL=C sort | xargs -P 2 -I HEADER bash -c 'check_header HEADER'
