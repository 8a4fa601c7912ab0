#!/usr/bin/env bash
# Usage: run_fuzzers.sh BUILD_DIR SECONDS [TARGET...]
# Builds the fuzz targets with clang's sanitizers and runs them one after the other, SECONDS in all. An
# input that breaks a target is left in BUILD_DIR; run the target on it to see why. New inputs are
# collected in BUILD_DIR and not added to the corpus.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
build=$1
seconds=$2
shift 2
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  targets=(manifold_builder hole_closing reconstruction readers)
fi
mkdir -p "$build"
build=$(cd "$build" && pwd)
compile=(clang++)
if command -v ccache > /dev/null; then
  compile=(ccache clang++)
fi

build_target() {
  "${compile[@]}" -std=c++17 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all \
    -D_GLIBCXX_ASSERTIONS -DCGAL_EIGEN3_ENABLED -I "$here/../../../include" -isystem /usr/include/eigen3 \
    -c "$here/isr_fuzz_$1.cpp" -o "$build/isr_fuzz_$1.o"
  clang++ -fsanitize=fuzzer,address,undefined "$build/isr_fuzz_$1.o" -o "$build/isr_fuzz_$1" -lgmp -lmpfr
}

for target in "${targets[@]}"; do
  echo "fuzz target $target"
  build_target "$target"
done

for target in "${targets[@]}"; do
  mkdir -p "$build/new_$target"
  (cd "$build" && "./isr_fuzz_$target" -seed=1 -max_total_time=$((seconds / ${#targets[@]})) -timeout=25 -max_len=1024 \
    -artifact_prefix="$build/broken_$target-" -print_final_stats=1 -verbosity=1 \
    "$build/new_$target" "$here/corpus/$target" 2>&1 | grep -v '^#.*\(NEW\|REDUCE\|pulse\)' | tail -n 40)
done
