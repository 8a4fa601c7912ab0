#!/bin/sh
# Builds the manual with the doxygen of the system. Warnings are errors.
# usage: build_documentation.sh OUTPUT_FOLDER
set -eu

if [ $# -ne 1 ]; then
  echo "usage: $0 OUTPUT_FOLDER" >&2
  exit 2
fi
command -v doxygen >/dev/null || { echo "$0: doxygen not found (apt install doxygen)" >&2; exit 3; }

mkdir -p "$1"
output=$(cd "$1" && pwd)
doc=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$doc/../.." && pwd)

sed -e "s|@ISR_OUTPUT_DIR@|$output|g" \
    -e "s|@ISR_DOC_DIR@|$doc|g" \
    -e "s|@ISR_INCLUDE_DIR@|$root/include|g" \
    -e "s|@ISR_EXAMPLES_DIR@|$root/examples|g" \
    "$doc/Doxyfile_standalone.in" > "$output/Doxyfile"
doxygen "$output/Doxyfile"
echo "$output/html/index.html"
