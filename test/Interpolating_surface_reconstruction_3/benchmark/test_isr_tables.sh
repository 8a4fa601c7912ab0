#!/usr/bin/env bash
# Usage: test_isr_tables.sh PYTHON ISR_TABLES DIRECTORY
# The quick run of the benchmark is complete, resumes, and survives methods that fail.
set -euo pipefail

python=$1
program=$2
directory=$3
here=$(cd "$(dirname "$0")" && pwd)
make_tables=$here/../../../benchmark/Interpolating_surface_reconstruction_3/make_tables.py

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

run() {
  "$python" "$make_tables" --program "$program" "$@"
}

rm -rf "$directory"
mkdir -p "$directory"

# Complete: --check asserts what a complete run has.
run --quick --check --output "$directory/quick"

# Resumed: a lost and a damaged row are made again, others are not.
rows=$directory/quick/rows
rm "$rows/generated-knot__ctc__t1.json"
echo '{"model": "gener' > "$rows/generated-sphere__af__t1.json"
run --quick --check --output "$directory/quick" > "$directory/resumed.txt"
[ "$(grep '^\[' "$directory/resumed.txt" | grep -vc 'there already')" -eq 2 ] || fail "not resumed"

# A method that is too slow or too large has a row that says so.
run --quick --check --only generated-knot --methods poisson,af --largest 0 --time-limit 0.05 --memory-limit 2000 \
  --output "$directory/slow"
grep -q 'generated-knot,Poisson,failed: time limit more than 0.05 s' "$directory/slow/tables/measures.csv" ||
  fail "no row of a method that is too slow"
run --quick --check --only generated-knot --methods poisson,af --largest 0 --memory-limit 18 \
  --output "$directory/large"
grep -q 'generated-knot,Poisson,failed: memory limit' "$directory/large/tables/measures.csv" ||
  fail "no row of a method that is too large"

# Failed rows are kept, unless they shall be tried again.
run --quick --check --only generated-knot --methods poisson,af --largest 0 --retry --output "$directory/slow"
grep -q 'generated-knot,Poisson,ok' "$directory/slow/tables/measures.csv" || fail "not tried again"

if run --quick --methods none --output "$directory/none" 2> "$directory/none.txt"; then
  fail "an unknown method is accepted"
fi
grep -q 'no such method: none' "$directory/none.txt" || fail "an unknown method is not named"
echo "passed"
