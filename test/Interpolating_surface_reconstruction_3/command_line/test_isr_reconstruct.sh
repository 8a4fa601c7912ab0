#!/usr/bin/env bash
# Usage: test_isr_reconstruct.sh PROGRAM DUMP_PLY DATA_DIR WORK_DIR
# Runs isr_reconstruct as users do, rightly and wrongly. WORK_DIR is emptied first.
set -uo pipefail

program=$(realpath "$1") dump_ply=$(realpath "$2") data=$(realpath "$3") work=$(realpath -m "$4")
[ -x "$program" ] && [ -x "$dump_ply" ] && [ -d "$data" ] || exit 1
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1

checks=0 failures=0
check() { # check DESCRIPTION COMMAND...
  local description=$1
  shift
  checks=$((checks + 1))
  if ! "$@"; then
    failures=$((failures + 1))
    echo "FAILED: $description"
  fi
}

equal() { [ "$1" = "$2" ] || { echo "  '$1' is not '$2'"; false; }; }
one_line() { [ "$(wc -l < "$1")" -eq 1 ] || { cat "$1"; false; }; }

# fails STATUS ARGUMENTS...: the program ends with this status, says one line, leaves no file
fails() {
  local status=$1
  shift
  mkdir run
  pushd run > /dev/null || exit 1
  "$program" "$@" > ../out.txt 2> ../err.txt < /dev/null
  check "status of: $*" equal $? "$status"
  check "one line on stderr of: $*" one_line ../err.txt
  check "stdout of: $*" equal "$(cat ../out.txt)" ""
  check "leftovers of: $*" equal "$(ls -A)" ""
  popd > /dev/null || exit 1
  rm -r run
}

# succeeds ARGUMENTS...: status 0 and nothing on stderr, so no progress bar either
succeeds() {
  "$program" "$@" > out.txt 2> err.txt < /dev/null
  check "status of: $*" equal $? 0
  check "stderr of: $*" equal "$(cat err.txt)" ""
}

triangles() { sed -n 's/^triangles: *//p' out.txt; }

# Help -------------------------------------------------------------------------------------------
succeeds --help
check "help names the exit statuses" grep -q 'Exit status' out.txt
succeeds --version
check "version" grep -q '^isr_reconstruct [0-9]' out.txt

# Every format in, every format out --------------------------------------------------------------
cp "$data"/sphere.xyz sphere.xyz
cp "$data"/sphere.xyz sphere.pwn
cp "$data"/sphere.xyz UPPER.XYZ
{ echo OFF; echo "500 0 0"; cat sphere.xyz; } > sphere.off
sed 's/^/v /' sphere.xyz > sphere.obj
{
  printf 'ply\nformat ascii 1.0\nelement vertex 500\n'
  printf 'property double x\nproperty double y\nproperty double z\nend_header\n'
  cat sphere.xyz
} > sphere.ply
# what stands behind the vertices is not read, however long it claims to be
sed -e 's/^end_header/element face 1\nproperty list uint int vertex_indices\nend_header/' \
  -e '$a 4000000000 0 1 2' sphere.ply > sphere_with_face.ply
succeeds sphere.xyz sphere_mesh.off
expected=$(triangles)
check "some triangles" test "$expected" -gt 900
for input in sphere.pwn sphere.off sphere.obj sphere.ply sphere_with_face.ply UPPER.XYZ; do
  succeeds "$input" mesh.off
  check "triangles from $input" equal "$(triangles)" "$expected"
  check "mesh from $input" cmp mesh.off sphere_mesh.off
done
for extension in ply off obj stl; do
  succeeds sphere.xyz "mesh.$extension"
  check "triangles in .$extension" equal "$(triangles)" "$expected"
done
check "OFF counts" equal "$(sed -n 2p mesh.off)" "500 $expected 0"
check "OBJ faces" equal "$(grep -c '^f' mesh.obj)" "$expected"
check "STL size" equal "$(stat -c %s mesh.stl)" $((84 + 50 * expected))
check "PLY header" grep -aq "element face $expected" mesh.ply
for input in mesh.ply mesh.off mesh.obj; do # the vertices of a mesh are points
  succeeds "$input" again.off
  check "triangles from the vertices of $input" equal "$(triangles)" "$expected"
done
check "no temporary file" equal "$(find . -name '.*' -type f)" ""

# Options ----------------------------------------------------------------------------------------
succeeds sphere.xyz quiet.off --quiet
check "quiet" equal "$(cat out.txt)" ""
succeeds sphere.xyz one.ply --threads 1
cp one.ply one_thread.ply
if "$program" --version | grep -q 'with TBB'; then
  succeeds sphere.xyz one.ply --threads 2
  check "one and two threads" cmp one.ply one_thread.ply
fi
succeeds "$data"/bowl.xyz bowl.off --keep-boundaries
check "the bowl has a rim" equal "$(sed -n 's/^boundary loops: *//p' out.txt)" 1
succeeds "$data"/bowl.xyz bowl.off --maximum-hole-size 0
check "the bowl is not closed" test "$(sed -n 's/^boundary edges: *//p' out.txt)" -gt 3
succeeds sphere.xyz radius.off --neighbor-radius 100
check "a large radius changes nothing" cmp radius.off sphere_mesh.off

for method in ctc pcr; do
  succeeds sphere.xyz method.off --method "$method"
  check "triangles by $method" equal "$(triangles)" 996
done
succeeds sphere.xyz lis.off --method lis
check "lis makes as many triangles" equal "$(triangles)" "$expected"
succeeds sphere.xyz lis_fine.ply --method lis --grid-spacing 0.05
check "finer triangles" test "$(triangles)" -gt "$((3 * expected))"

# Statistics -------------------------------------------------------------------------------------
odd_name=$'a "quoted" back\\slash \ttab.xyz'
cp sphere.xyz "$odd_name"
succeeds "$odd_name" mesh.ply --stats stats.json
keys="threads;points_read;points_duplicate;points_non_finite;points_unused;vertices;triangles"
keys="$keys;components;boundary_loops;boundary_edges;euler_characteristic;seconds"
keys="$keys;points_per_second;peak_memory_bytes"
check "statistics are JSON" cmake -D FILE=stats.json -D INPUT="$odd_name" -D KEYS="$keys" \
  -P "$here/check_json.cmake"
cat sphere.xyz sphere.xyz > twice.xyz
succeeds twice.xyz twice.off
check "duplicates" grep -q '^set aside, duplicate: *500$' out.txt
check "duplicates change nothing" cmp twice.off sphere_mesh.off

# Properties -------------------------------------------------------------------------------------
in_order() { # the vertices below a header line, sorted, with the digits of the data
  awk 'NR > 1 { printf "%.6f %.6f %.6f", $1, $2, $3; for (i = 4; i <= NF; ++i) printf " %g", $i; print "" }' |
    sed 's/-0\.000000/0.000000/g' | sort
}
succeeds "$data"/colored_sphere.ply colored.ply
"$dump_ply" colored.ply > dump.txt
check "names of the properties" equal "$(head -n 1 dump.txt)" \
  "x y z red green blue confidence index "
sed -n '/end_header/,$p' "$data"/colored_sphere.ply | in_order > expected.txt
in_order < dump.txt > carried.txt
check "values of the properties, read from ASCII" cmp carried.txt expected.txt
succeeds colored.ply colored_again.ply
"$dump_ply" colored_again.ply | in_order > carried.txt
check "values of the properties, read from binary" cmp carried.txt expected.txt
succeeds "$data"/colored_sphere.ply colored.off
check "colors in OFF" equal "$(head -n 1 colored.off)" "COFF"
awk 'NR > 1 && NF >= 6 { print $1, $2, $3, $4, $5, $6 }' colored.off | sed '1i header' | in_order > carried.txt
cut -d ' ' -f 1-6 expected.txt > expected_colors.txt
check "values of the colors in OFF" cmp carried.txt expected_colors.txt
awk '{ print $1, $2, $3, -$1, -$2, -$3 }' sphere.xyz > inward.xyz
succeeds inward.xyz inward.ply
check "normals are carried" equal "$("$dump_ply" inward.ply | head -n 1)" "x y z nx ny nz "
succeeds inward.ply inward.obj
first_triangle_is_inward() { # by the sign of the volume of the triangle and the origin
  awk '$1 == "v" { ++n; x[n] = $2; y[n] = $3; z[n] = $4 }
       $1 == "f" {
         gsub("/[^ ]*", ""); a = $2; b = $3; c = $4
         volume = x[a] * (y[b] * z[c] - z[b] * y[c])
         volume += y[a] * (z[b] * x[c] - x[b] * z[c])
         volume += z[a] * (x[b] * y[c] - y[b] * x[c])
         exit !(volume < 0)
       }' "$1"
}
check "given normals orient the surface" first_triangle_is_inward inward.obj
succeeds inward.ply outward.obj --ignore-normals
check "outward without normals" equal "$(first_triangle_is_inward outward.obj; echo $?)" 1

# Failures ---------------------------------------------------------------------------------------
sphere=$work/sphere.xyz
fails 2
fails 2 "$sphere"
fails 2 "$sphere" mesh.ply more
fails 2 "$sphere" mesh.ply --no-such-option
fails 2 "$sphere" mesh.ply --threads 0
fails 2 "$sphere" mesh.ply --threads many
fails 2 "$sphere" mesh.ply --maximum-hole-size -1
fails 2 "$sphere" mesh.ply --neighbor-radius nan
fails 2 "$sphere" mesh.ply --neighbor-radius -1
fails 2 "$sphere" mesh.ply --method no-such-method
fails 2 "$sphere" mesh.ply --method lis --grid-spacing -1
fails 2 "$sphere" mesh.ply --stats ./mesh.ply
fails 2 "$work/mesh.ply" "$work/mesh.ply"
fails 3 "$work/missing.xyz" mesh.ply
mkdir directory.xyz
fails 3 "$work/directory.xyz" mesh.ply
if [ "$(id -u)" -ne 0 ]; then
  cp sphere.xyz secret.xyz
  chmod 000 secret.xyz
  fails 3 "$work/secret.xyz" mesh.ply
fi
cp sphere.xyz sphere.unknown
fails 4 "$work/sphere.unknown" mesh.ply
fails 4 "$sphere" mesh.unknown
fails 4 "$sphere" mesh
for extension in ply xyz pwn off obj; do
  : > "empty.$extension"
  fails 5 "$work/empty.$extension" mesh.ply
  head -c 3000 /dev/urandom > "garbage.$extension"
  fails 6 "$work/garbage.$extension" mesh.ply
done
echo '# no points' > comment.xyz
fails 5 "$work/comment.xyz" mesh.ply
printf 'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n' \
  > none.ply
fails 5 "$work/none.ply" mesh.ply
printf 'ply\nformat ascii 1.0\nproperty float x\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n' \
  > no_element.ply
fails 6 "$work/no_element.ply" mesh.ply
{
  printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty list uint int neighbors\n'
  printf 'property float x\nproperty float y\nproperty float z\nend_header\n4000000000 0 0 0 0\n'
} > list.ply
fails 6 "$work/list.ply" mesh.ply
head -c 5000 colored.ply > truncated_binary.ply
fails 6 "$work/truncated_binary.ply" mesh.ply
head -c 5000 "$data"/colored_sphere.ply > truncated_ascii.ply
fails 6 "$work/truncated_ascii.ply" mesh.ply
head -c 100 colored.ply > truncated_header.ply
fails 6 "$work/truncated_header.ply" mesh.ply
head -n 100 sphere.off > truncated.off
fails 6 "$work/truncated.off" mesh.ply
sed 's/property float y/property int y/' "$data"/colored_sphere.ply > mixed_types.ply
fails 6 "$work/mixed_types.ply" mesh.ply
sed 's/element vertex 500/element vertex 99999999999999999/' "$data"/colored_sphere.ply > huge.ply
fails 6 "$work/huge.ply" mesh.ply
{
  printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4\n'
  printf 'property float x\nproperty float y\nproperty float z\nend_header\n'
  for _ in 1 2 3 4 5 6 7 8 9 10 11 12; do printf '\000\000\300\177'; done
} > nan.ply
fails 7 "$work/nan.ply" mesh.ply
check "points that are not finite are counted" grep -q '4 are not finite' err.txt
printf '0 0 0\n1 1 1\n2 2 2\n3 3 3\n' > collinear.xyz
fails 7 "$work/collinear.xyz" mesh.ply --stats stats.json
printf '0 0 0\n' > one.xyz
fails 7 "$work/one.xyz" mesh.ply
fails 8 "$sphere" no/such/directory/mesh.ply
fails 8 "$sphere" mesh.ply --stats no/such/directory/stats.json
mkdir directory.ply
fails 8 "$sphere" "$work/directory.ply"
if [ -w /dev/full ]; then
  ln -s /dev/full device.ply
  fails 8 "$sphere" "$work/device.ply"
fi

# A failure leaves the old output as it was.
echo old > old.ply
"$program" nan.ply old.ply 2> /dev/null
check "old output" equal "$(cat old.ply)" old

# No space for the output: the limit stops the write in the middle.
mkdir run
(cd run && trap '' XFSZ && ulimit -f 1 && "$program" "$data"/sphere.xyz mesh.ply 2> ../err.txt > /dev/null)
check "status without space" equal $? 8
check "leftovers without space" equal "$(ls -A run)" ""

# Interruption -----------------------------------------------------------------------------------
# interrupted WHEN ARGUMENTS...: a signal after WHEN seconds ends the program cleanly
interrupted() {
  local when=$1 pid
  shift
  (cd run && exec "$program" "$@" > /dev/null 2> ../err.txt) &
  pid=$!
  sleep "$when"
  kill -TERM "$pid"
  wait "$pid"
  check "status of an interrupted run" equal $? 130
  check "one line of an interrupted run" one_line err.txt
  check "leftovers of an interrupted run" equal "$(ls -A run)" ""
}

mkfifo endless.xyz
yes '0 0 0' > endless.xyz &
interrupted 0.5 "$work/endless.xyz" mesh.ply

# A signal at two thirds of the time of an undisturbed run falls into the reconstruction.
awk 'BEGIN { for (i = 0; i < 500; ++i) for (j = 0; j < 500; ++j)
               print i, j, 20 * sin(i / 40) * cos(j / 30) }' > waves.xyz
begin=$(date +%s%N)
succeeds waves.xyz waves.ply --threads 1
interrupted "$(awk -v ns=$(($(date +%s%N) - begin)) 'BEGIN { printf "%.3f", ns / 1.5e9 }')" \
  "$work/waves.xyz" mesh.ply --threads 1

# Terminal ---------------------------------------------------------------------------------------
if command -v script > /dev/null; then
  script -qec "'$program' sphere.xyz mesh.ply" /dev/null > terminal.txt < /dev/null
  check "progress bar on a terminal" grep -q '#' terminal.txt
  script -qec "'$program' sphere.xyz mesh.ply --quiet" /dev/null > terminal.txt < /dev/null
  check "no progress bar with --quiet" equal "$(cat terminal.txt)" ""
fi

echo "$checks checks, $failures failed"
[ "$failures" -eq 0 ]
