#!/usr/bin/env bash
# Usage: check_package.sh [--update]
# Checks what CGAL asks of the files of a package, prints what is wrong, and fails if anything is.
# --update writes the lists that are generated: doc/…/examples.txt.
set -euo pipefail
shopt -s nullglob

cd "$(dirname "$0")/../../.."
package=Interpolating_surface_reconstruction_3
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
complaints=0

complain() {
  echo "$*"
  complaints=$((complaints + 1))
}

# The files of the package: sources, scripts, texts.
files=$(find include doc examples test benchmark package_info CMakeLists.txt README.md -type f \
  ! -path '*/corpus/*' 2> /dev/null | LC_ALL=C sort)
headers=$(find include -name '*.h' | LC_ALL=C sort)
text_files=$(grep -vE '\.(png|svg|ply|xyz)$' <<< "$files")

check_headers() {
  local header guard
  for header in $headers; do
    guard=$(sed 's#^include/##; s#[/.]#_#g' <<< "$header" | tr '[:lower:]' '[:upper:]')
    grep -qx "#ifndef $guard" "$header" && grep -qx "#define $guard" "$header" &&
      [ "$(tail -n 1 "$header")" = "#endif // $guard" ] || complain "$header: the include guard is not $guard"
    grep -qx '// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial' "$header" ||
      complain "$header: no SPDX line"
    grep -q '^// Copyright (c) [0-9]\{4\}  ' "$header" || complain "$header: no copyright"
    grep -q '^// \$URL\$$' "$header" && grep -q '^// \$Id\$$' "$header" || complain "$header: no \$URL\$ or \$Id\$"
    if [[ $header != */license/* ]]; then
      grep -qx "#include <CGAL/license/$package.h>" "$header" || complain "$header: the license is not included"
    fi
    # one screen is 60 lines; a stage that needs more than seven of them is two stages
    [ "$(wc -l < "$header")" -le 440 ] || complain "$header: more than 440 lines"
  done
}

# Words of one version of CGAL only, or of old C++.
check_words() {
  local words='boost::(optional|variant|shared_ptr|function)\b|CGAL_static_assertion|CGAL::Octree\b|has_normal_map|\.property_map<|using namespace std'
  if grep -nE "$words" $headers examples/$package/*.cpp; then
    complain "words of one version of CGAL only, above"
  fi
}

check_text() {
  local file
  for file in $text_files; do
    iconv -f UTF-8 -t UTF-8 "$file" > /dev/null 2>&1 || complain "$file: not UTF-8"
    if grep -nP '\t|[ \t]$|\r' "$file"; then
      complain "$file: a tab, a blank at the end of a line, or a carriage return"
    fi
    [ -z "$(tail -c 1 "$file")" ] || complain "$file: no newline at the end"
  done
}

# The layout of the sources; other versions of clang-format have other ideas of the same options.
check_format() {
  local formatter=clang-format-14
  if ! command -v $formatter > /dev/null; then
    echo "$formatter not found: the format is not checked"
    return
  fi
  # one process: to start one takes longer than to check a file
  grep -E '\.(h|cpp)$' <<< "$files" | grep -v '^doc/.*/Concepts/' |
    xargs $formatter --dry-run -Werror 2> "$scratch/format" ||
    complain "run $formatter -i: $(sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: error: .*/\1/p' "$scratch/format" | uniq | xargs)"
}

# Scripts can be run, other files cannot.
check_modes() {
  local file
  for file in $files; do
    if [ "$(head -c 2 "$file" | tr -d '\0')" = '#!' ]; then
      [ -x "$file" ] || complain "$file: not executable"
    elif [ -x "$file" ]; then
      complain "$file: executable"
    fi
  done
}

check_names() {
  local twins
  twins=$(tr '[:upper:]' '[:lower:]' <<< "$files" | LC_ALL=C sort | uniq -d)
  [ -z "$twins" ] || complain "names that differ by case only: $twins"
  # every program is a target of one build
  twins=$(grep '\.cpp$' <<< "$files" | grep -v outside_project | sed 's#.*/##' | LC_ALL=C sort | uniq -d)
  [ -z "$twins" ] || complain "programs of the same name: $twins"
}

check_package_info() {
  local file
  for file in copyright dependencies description.txt license.txt long_description.txt maintainer; do
    [ -s "package_info/$package/$file" ] || complain "package_info/$package/$file: missing or empty"
  done
}

check_projects() {
  local folder
  for folder in test examples; do
    [ -f "$folder/$package/CMakeLists.txt" ] || complain "$folder/$package/CMakeLists.txt: missing"
  done
  grep -q "^project(${package}_Tests\b" "test/$package/CMakeLists.txt" || complain "test: not a project ${package}_Tests"
  grep -q "^project(${package}_Examples\b" "examples/$package/CMakeLists.txt" ||
    complain "examples: not a project ${package}_Examples"
}

# Every example is in the manual's list, is run by CTest and fits on a screen; every public function has one.
check_examples() {
  local example name function
  {
    echo '/*!'
    for example in examples/$package/*.cpp; do echo "\\example $package/${example##*/}"; done
    echo '*/'
  } > "$scratch/examples.txt"
  [ "${1:-}" != --update ] || cp "$scratch/examples.txt" "doc/$package/examples.txt"
  diff "doc/$package/examples.txt" "$scratch/examples.txt" || complain "doc/$package/examples.txt: run $0 --update"
  for example in examples/$package/*.cpp; do
    name=$(basename "$example" .cpp)
    grep -q "isr_add_example($name \|add_executable($name " "examples/$package/CMakeLists.txt" ||
      complain "$example: not built"
    grep -q "$name" "doc/$package/$package.txt" || complain "$example: not in the manual"
    case $name in
      isr_reconstruct) ;; # a program for users
      isr_lis_function) ;; # for two versions of CGAL
      *) [ "$(wc -l < "$example")" -le 60 ] || complain "$example: more than 60 lines" ;;
    esac
  done
  for function in ctc_reconstruction pcr_reconstruction lis_reconstruction triangles_to_surface_mesh \
    linear_implicit_isosurface Linear_implicit_function_3 Quadratic_weight Regularity_star_3 Default_visitor \
    point_map neighbor_radius maximum_hole_size keep_boundaries star_construction callback visitor grid_spacing; do
    grep -q "\b$function\b" examples/$package/isr_*.cpp || complain "$function: no example"
  done
}

# Named parameters that are documented are those that are allowed: FILE_WITH_TEXT FILE_WITH_LIST
check_named_parameters() {
  sed -n 's/.*\\cgalParamNBegin{\(.*\)}.*/\1/p' "$1" | LC_ALL=C sort > "$scratch/documented"
  tr '\n' ' ' < "$2" | grep -o 'Only_allowed<[^>]*>' | grep -o 'internal_np::[a-z_]*_t' |
    sed 's/internal_np::\(.*\)_t/\1/; s/^point$/point_map/; s/^normal$/normal_map/' | LC_ALL=C sort > "$scratch/allowed"
  diff "$scratch/documented" "$scratch/allowed" || complain "$1: other named parameters than $2"
}

# Everything public is among the classified reference pages.
check_reference() {
  local name
  for name in $(ls include/CGAL/$package/*.h doc/$package/Concepts/*.h | sed 's#.*/##; s/\.h$//') \
    ctc_reconstruction pcr_reconstruction lis_reconstruction; do
    case $name in
      parameters | linear_implicit_weights) ;; # not named after what they hold
      *) grep -q "\b$name\b" "doc/$package/PackageDescription.txt" || complain "$name: not in PackageDescription.txt" ;;
    esac
  done
}

check_headers
check_words
check_text
check_format
check_modes
check_names
check_package_info
check_projects
check_examples "${1:-}"
check_named_parameters include/CGAL/ctc_reconstruction.h include/CGAL/$package/internal/reconstruction_call.h
check_named_parameters include/CGAL/lis_reconstruction.h include/CGAL/$package/internal/lis_call.h
check_named_parameters include/CGAL/$package/Linear_implicit_function_3.h include/CGAL/$package/Linear_implicit_function_3.h
check_reference

echo "$complaints complaints"
[ "$complaints" -eq 0 ]
