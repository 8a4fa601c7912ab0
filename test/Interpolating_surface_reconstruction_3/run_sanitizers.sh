#!/usr/bin/env bash
# Usage: run_sanitizers.sh BUILD_DIR [CTEST_OPTION...]
# Runs every test with the address and undefined behavior sanitizers and the assertions of the standard
# library, once with NDEBUG and once without; then without sanitizers and with CGAL's expensive checks.
# Takes hours on one processor. Ends with an error if any test fails; the tests after it are still run.
set -uo pipefail

here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
build=$(cd "$1" && pwd)
shift
ctest_options=("$@")

export ASAN_OPTIONS=detect_stack_use_after_return=1:fast_unwind_on_malloc=0
export LSAN_OPTIONS="suppressions=$here/lsan_suppressions.txt"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
sanitizers="-g1 -fsanitize=address,undefined -fno-sanitize-recover=all"

# Arguments: a name, and the options of the compiler.
run_suite() {
  cmake -S "$here" -B "$build/$1" -D CMAKE_BUILD_TYPE=Release -D CGAL_ISR_TEST_TIMEOUT=7200 \
    -D CMAKE_CXX_FLAGS_RELEASE="-O1 -D_GLIBCXX_ASSERTIONS $2" &&
    cmake --build "$build/$1" --parallel "$(nproc)" &&
    ctest --test-dir "$build/$1" --output-on-failure ${ctest_options[@]+"${ctest_options[@]}"}
}

status=0
run_suite sanitizers_ndebug "$sanitizers -DNDEBUG" || status=1
run_suite sanitizers "$sanitizers" || status=1
run_suite expensive_checks "-DCGAL_CHECK_EXPENSIVE" || status=1
exit $status
