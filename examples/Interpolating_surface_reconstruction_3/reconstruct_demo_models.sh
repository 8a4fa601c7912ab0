#!/usr/bin/env bash
# Reconstructs two point sets that Debian ships for CGAL's demos: the vertices of the Armadillo and
# the points of the kitten. Installs what is missing, builds isr_reconstruct, and leaves meshes,
# statistics and pictures in ./output.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
output=$PWD/output
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$here"/install_packages.sh g++ make cmake libcgal-dev libeigen3-dev libtbb-dev \
  libboost-program-options-dev libcgal-demo f3d xvfb xauth libgl1-mesa-dri

echo "Building isr_reconstruct"
cmake -S "$root" -B "$root"/build -D CMAKE_BUILD_TYPE=Release -D CGAL_ISR_BUILD_TESTS=OFF \
  -D CGAL_ISR_BUILD_EXAMPLES=ON -D CGAL_ISR_BUILD_BENCHMARK=OFF > "$scratch"/log || { cat "$scratch"/log; exit 1; }
cmake --build "$root"/build --target isr_reconstruct
program=$(find "$root"/build -name isr_reconstruct -type f -perm -u+x)

# Minimal installations of Debian leave out the documentation of a package, and with it the data.
archive=/usr/share/doc/libcgal-dev/data.tar.gz
if [ ! -e "$archive" ]; then
  (cd "$scratch" && apt-get -q download libcgal-demo)
  dpkg-deb --extract "$scratch"/libcgal-demo_*.deb "$scratch"
  archive=$scratch$archive
fi
tar -xzf "$archive" -C "$scratch" data/meshes/armadillo.off data/points_3/kitten.xyz

# picture MESH PNG OPTION...: renders without a screen
picture() {
  local mesh=$1 png=$2
  shift 2
  xvfb-run -a -s "-screen 0 1024x768x24" \
    f3d "$mesh" --dry-run --quiet --output="$png" --resolution=450,450 --bg-color=1,1,1 \
    --color=2.2,2.4,2.8 --roughness=0.8 --camera-view-angle=24 --ssao --fxaa "$@" < /dev/null
  test -s "$png"
}

# reconstruct NAME POINTS OPTION...: mesh, statistics and picture of a point set
reconstruct() {
  local name=$1 points=$2
  shift 2
  printf '\n== %s ==\n' "$name"
  "$program" "$points" "$output/$name.ply" --stats "$output/$name.json"
  picture "$output/$name.ply" "$output/$name.png" "$@"
}

mkdir -p "$output"
reconstruct armadillo "$scratch"/data/meshes/armadillo.off \
  --camera-azimuth-angle=200 --camera-elevation-angle=5
reconstruct kitten "$scratch"/data/points_3/kitten.xyz \
  --edges --camera-azimuth-angle=30 --camera-elevation-angle=15

printf '\nMeshes, statistics and pictures:\n'
ls -l "$output"
