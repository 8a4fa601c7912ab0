#!/usr/bin/env bash
# Usage: run_tests.sh [CMAKE_OPTION...]
# Installs what is missing, builds tests, examples and benchmarks, and runs every test.
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build-tests

"$root"/examples/Interpolating_surface_reconstruction_3/install_packages.sh \
  g++ cmake ninja-build ccache libcgal-dev libeigen3-dev libtbb-dev libboost-program-options-dev \
  libbenchmark-dev clang clang-format clang-tidy libclang-rt-dev doxygen python3 python3-matplotlib

# The tests are small: compiling takes most of the time, and half as long as with -O3.
# Ninja does not wait for a library before it compiles what will be linked with it.
cmake -S "$root" -B "$build" -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
  -D CGAL_ISR_WARNINGS_AS_ERRORS=ON -D CGAL_ISR_USE_PRECOMPILED_HEADERS=ON "$@"
cmake --build "$build" --parallel "$(nproc)"
ctest --test-dir "$build" --verbose --parallel "$(nproc)" < /dev/null

# Coverage-guided, with the address and undefined behavior sanitizers and all assertions.
fuzzing_seconds=60
"$root"/test/Interpolating_surface_reconstruction_3/fuzz/run_fuzzers.sh "$build/fuzz" "$fuzzing_seconds"
