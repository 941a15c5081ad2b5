#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/bench_baker.sh [--smoke]
# Measures the baker against Embree alone, its convergence, threads and memory, and writes the tables of docs/scale.md,
# between their two marker comments. Times are of this machine: leave it alone for the two minutes. With --smoke it only
# tries every measurement on little work, and writes nothing.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=(cornell.obj testcard.obj product.obj gallery.json)
share_rows=30        # of 1448 texels at 16 paths
convergence_rows=10  # of 64 texels
thread_rows=200
triangles=500000
bench=${LUMI_BAKER_BENCH:-$root/build/release/baker/bench/lumi_baker_bench}
page=$root/docs/scale.md
begin_marker='<!-- baker tables: begin (tools/bench_baker.sh) -->'
end_marker='<!-- baker tables: end -->'
tables=$(mktemp)
trap 'rm -f "$tables"' EXIT

# for_scenes COMMAND ROWS
for_scenes() {
  local scene
  for scene in "${scenes[@]}"; do
    "$bench" "$1" "$root/baker/scenes/$scene" "$2"
  done
}

processor() {
  awk -F': ' '/^model name/ { print $2; exit }' /proc/cpuinfo
}

print_tables() {
  printf 'One thread of %s; millions a CPU second, the best of five runs. A path is a light path from the eye, a ray\nwhat Embree is asked for.\n\n' "$(processor)"
  printf '| scene | triangles | rays a path | paths | rays | rays, Embree alone | share of Embree |\n|---|---|---|---|---|---|---|\n'
  for_scenes share "$share_rows"
  printf '\nRms error in steps of 255 against 4,096 paths, over 640 texels, and the exponent of the number of paths by which it falls\n(independent samples: -0.5).\n\n'
  printf '| scene | 4 paths | 16 | 64 | 256 | exponent |\n|---|---|---|---|---|---|\n'
  for_scenes convergence "$convergence_rows"
  printf '\nMillions of paths a second by the clock.\n\n| scene | threads | paths | times one thread |\n|---|---|---|---|\n'
  "$bench" threads "$root/baker/scenes/product.obj" "$thread_rows"
  printf '\nMemory of a mesh with texture coordinates and smooth normals, for each million triangles.\n\n'
  printf '| triangles | OBJ file | held while baking | most, while loading |\n|---|---|---|---|\n'
  "$bench" memory "$triangles"
}

write_page() {
  local new
  new=$(awk -v begin="$begin_marker" -v end="$end_marker" -v table="$tables" '
    $0 == end { inside = 0 }
    !inside { print }
    $0 == begin { inside = 1; while ((getline line < table) > 0) print line }' "$page")
  printf '%s\n' "$new" >"$page"
}

main() {
  case ${1:-} in
    '') ;;
    --smoke) share_rows=1 convergence_rows=1 thread_rows=2 triangles=2000 scenes=(cornell.obj) ;;
    --help) help "$0" && exit ;;
    *) wrong_call "unknown option '$1'" ;;
  esac
  [[ -x $bench ]] || die "$bench is missing: build it with 'cmake --preset release && cmake --build --preset release'"
  print_tables >"$tables"
  cat "$tables"
  [[ ${1:-} == --smoke ]] || write_page
}

main "$@"
