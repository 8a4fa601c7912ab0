#!/usr/bin/env bash
# Usage: run_thread_sanitizer.sh BUILD_DIR TBB_SOURCE_DIR [N]
# Builds TBB from its sources ("apt-get source onetbb", or a clone) and the tests of threads with clang's
# thread sanitizer, and runs them on inputs of N points (default 6000). The TBB of a system does not do:
# what it synchronizes would not be seen. Ends with an error at the first race.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
build=$(cd "$1" && pwd)
n=${3:-6000}

cmake -S "$2" -B "$build/tbb" -D CMAKE_BUILD_TYPE=RelWithDebInfo -D CMAKE_C_COMPILER=clang \
  -D CMAKE_CXX_COMPILER=clang++ -D TBB_SANITIZE=thread -D TBB_TEST=OFF -D TBB_STRICT=OFF
cmake --build "$build/tbb" --target tbb --parallel "$(nproc)"

library=$(dirname "$(find "$build/tbb" -name libtbb.so)")

build_test() {
  clang++ -std=c++17 -O1 -g -fsanitize=thread -DCGAL_EIGEN3_ENABLED -DCGAL_LINKED_WITH_TBB \
    -I "$here/../../include" -isystem /usr/include/eigen3 "$here/$1.cpp" -o "$build/$1" \
    -L "$library" -Wl,-rpath,"$library" -ltbb -lgmp -lmpfr
}

export TSAN_OPTIONS=halt_on_error=1
build_test test_isr_cancel
"$build/test_isr_cancel"
build_test test_isr_determinism
for algorithm in CTC PCR LIS; do
  "$build/test_isr_determinism" "$algorithm" "$n"
done
