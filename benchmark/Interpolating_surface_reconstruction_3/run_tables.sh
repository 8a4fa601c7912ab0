#!/usr/bin/env bash
# Usage: run_tables.sh [--build DIR] [OPTION...]
# Installs what is missing (Debian 12, as root or with sudo), builds isr_tables, runs every method on
# every model, and leaves tables, plots, pictures and index.html in ./tables. --help lists the options.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build-benchmark
if [ "${1-}" = --build ]; then
  build=$2
  shift 2
fi

"$root"/examples/Interpolating_surface_reconstruction_3/install_packages.sh \
  g++ make cmake ccache libcgal-dev libeigen3-dev libtbb-dev python3 python3-matplotlib

cmake -S "$root" -B "$build" -D CMAKE_BUILD_TYPE=Release -D CGAL_ISR_BUILD_TESTS=OFF \
  -D CGAL_ISR_BUILD_EXAMPLES=OFF > /dev/null
cmake --build "$build" --target isr_tables --parallel "$(nproc)"

# Debian's own interpreter: another one does not see Debian's packages.
exec /usr/bin/python3 "$here"/make_tables.py \
  --program "$build"/benchmark/Interpolating_surface_reconstruction_3/isr_tables "$@"
