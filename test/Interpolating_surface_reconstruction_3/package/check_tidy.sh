#!/usr/bin/env bash
# Usage: check_tidy.sh [OPTION...]
# Runs the checks of /.clang-tidy on all public headers, and with them on the stages they include, in one
# translation unit. OPTION... are those of the compiler.
set -euo pipefail
shopt -s nullglob

cd "$(dirname "$0")/../../.."
tidy=clang-tidy-14 # others have other checks of the same names
if ! command -v $tidy > /dev/null; then
  echo "$tidy not found: not checked"
  exit 0
fi

scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
(cd include && printf '#include <%s>\n' CGAL/*_reconstruction.h CGAL/Interpolating_surface_reconstruction_3/*.h) \
  > "$scratch/all_headers.cpp"

$tidy --quiet --config-file=.clang-tidy "$scratch/all_headers.cpp" -- -std=c++17 -DCGAL_EIGEN3_ENABLED -Iinclude "$@"
