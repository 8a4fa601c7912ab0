#!/usr/bin/env bash
# Usage: run_fuzzers.sh BUILD_DIR SECONDS [TARGET...]
# Builds the fuzz targets with clang's sanitizers and runs them, as many at once as there are processors, SECONDS
# in all. An input that breaks a target is left in BUILD_DIR; run the target on it to see why. New inputs are
# collected in BUILD_DIR and not added to the corpus.
set -euo pipefail

export here build seconds compile
here=$(cd "$(dirname "$0")" && pwd)
build=$1
seconds=$2
shift 2
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  targets=(reconstruction hole_closing manifold_builder readers) # the longest to build first
fi
seconds=$((seconds / ${#targets[@]}))
mkdir -p "$build"
build=$(cd "$build" && pwd)
compile=clang++
if command -v ccache > /dev/null; then
  compile="ccache clang++"
fi

build_target() {
  $compile -std=c++17 -O1 -gline-tables-only -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all \
    -D_GLIBCXX_ASSERTIONS -DCGAL_EIGEN3_ENABLED -I "$here/../../../include" -isystem /usr/include/eigen3 \
    -c "$here/isr_fuzz_$1.cpp" -o "$build/isr_fuzz_$1.o"
  clang++ -fsanitize=fuzzer,address,undefined "$build/isr_fuzz_$1.o" -o "$build/isr_fuzz_$1" -lgmp -lmpfr
}

run_target() {
  mkdir -p "$build/new_$1"
  cd "$build"
  "./isr_fuzz_$1" -seed=1 -max_total_time="$seconds" -timeout=25 -max_len=1024 \
    -artifact_prefix="$build/broken_$1-" -print_final_stats=1 -verbosity=1 \
    "$build/new_$1" "$here/corpus/$1" 2>&1 | grep -v '^#.*\(NEW\|REDUCE\|pulse\)' | tail -n 40 |
    sed "s/^/$1: /"
}
export -f build_target run_target

for step in build_target run_target; do
  printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I TARGET bash -euo pipefail -c "$step TARGET"
done
