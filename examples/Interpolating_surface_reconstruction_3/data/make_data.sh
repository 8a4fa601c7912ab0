#!/usr/bin/env bash
# Writes the small point sets next to this script: points on a sphere along a golden-angle spiral.
set -euo pipefail
cd "$(dirname "$0")"

# spiral N HEIGHT: the points of a spiral of N points that lie below HEIGHT
spiral() {
  awk -v n="$1" -v height="$2" 'BEGIN {
    golden_angle = 2.399963229728653;
    for (i = 0; i < n; ++i) {
      z = 1 - (2 * i + 1) / n;
      r = sqrt(1 - z * z);
      if (z <= height)
        printf "%.6f %.6f %.6f\n", r * cos(i * golden_angle), r * sin(i * golden_angle), z;
    }
  }'
}

spiral 500 1 > sphere.xyz
spiral 500 0.3 > bowl.xyz

{
  printf 'ply\nformat ascii 1.0\ncomment colors show the position on the sphere\nelement vertex 500\n'
  printf 'property float x\nproperty float y\nproperty float z\n'
  printf 'property uchar red\nproperty uchar green\nproperty uchar blue\n'
  printf 'property float confidence\nproperty int index\nend_header\n'
  spiral 500 1 | awk '{
    printf "%s %s %s %d %d %d %.2f %d\n", $1, $2, $3,
           127.5 * (1 + $1), 127.5 * (1 + $2), 127.5 * (1 + $3), NR / 500, NR + 1000
  }'
} > colored_sphere.ply
