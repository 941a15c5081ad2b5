#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/bench_baker.sh [--smoke] [speed] [adaptive] [footprint]
# Measures the baker and prints rows of JSON; without a name, of all parts. speed: convergence, threads and memory; times are those of this machine: leave it alone for the two minutes.
# adaptive: what adaptive sampling leaves out. footprint: what footprints and beams show. The last two are the same on
# every machine of one kind. With --smoke it only tries every measurement on little work.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=(cornell.obj testcard.obj product.obj gallery.json)
convergence_rows=10  # rows of 64 texels
thread_rows=200
triangles=500000
adaptive_scenes=(cornell.obj product.obj gallery.json)
adaptive_texels=2000
footprint_scenes=(product.obj testcard.obj)
footprint_size=724  # origins and directions
footprints=(point origin 'origin --beam parallel' both 'both --beam parallel')
modes=(nearest linear)
orbit=30,20,3
views=4
picture=240x240
reference_spp=256
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# for_scenes COMMAND COUNT SCENE...
for_scenes() {
  local command=$1 count=$2 scene
  shift 2
  for scene; do
    "$lab" "$command" "$root/baker/scenes/$scene" "$count"
  done
}

print_convergence() {
  for_scenes convergence "$convergence_rows" "${scenes[@]}"
}

print_threads() {
  for_scenes threads "$thread_rows" "${scenes[@]}"
}

print_memory() {
  "$lab" memory "$triangles"
}

print_adaptive() {
  for_scenes adaptive "$adaptive_texels" "${adaptive_scenes[@]}"
}

# draw NAME COMMAND...: the pictures of a turntable, NAME-000.png and so on.
draw() {
  local name=$1
  shift
  "$@" -o "$work/$name.png" --orbit "$orbit" --size "$picture" --turntable "$views" >/dev/null
}

# Mean figures of the turntable NAME against the reference's.
figures() {
  local name=$1 view number
  for ((view = 0; view < views; ++view)); do
    printf -v number '%03d' "$view"
    "$lumi" compare "$work/$name-$number.png" "$work/reference-$number.png"
  done | mean_figures "$views"
}

print_footprint() {
  local scene footprint mode words row
  for scene in "${footprint_scenes[@]}"; do
    draw reference "$lumi" reference "$root/baker/scenes/$scene" --spp "$reference_spp"
    for footprint in "${footprints[@]}"; do
      read -ra words <<<"$footprint"
      "$lumi" bake "$root/baker/scenes/$scene" -o "$work/field.lumi" --origins "$footprint_size" \
        --directions "$footprint_size" --spp 16 --footprint "${words[@]}" >/dev/null
      row=(scene "$scene" footprint "$footprint")
      for mode in "${modes[@]}"; do
        draw "$mode" "$lumi" render "$work/field.lumi" --mode "$mode"
        row+=("$mode" "$(figures "$mode")")
      done
      json_row "${row[@]}"
    done
  done
}

parts=()
for word; do
  case $word in
    speed | adaptive | footprint) parts+=("$word") ;;
    --smoke)
      convergence_rows=1 thread_rows=2 triangles=2000 scenes=(cornell.obj)
      adaptive_scenes=(cornell.obj) adaptive_texels=20
      footprint_scenes=(cornell.obj) footprint_size=64 picture=32x32 views=1 reference_spp=4
      ;;
    --help) help "$0" && exit ;;
    *) wrong_call "unknown option '$word'" ;;
  esac
done
((${#parts[@]} > 0)) || parts=(speed adaptive footprint)
read -ra parts <<<"${parts[*]/#speed/convergence threads memory}"
for program in "$lab" "$lumi"; do
  [[ -x $program ]] || die "$program is missing: build it with 'cmake --preset release && cmake --build --preset release --target lumi lumi-lab'"
done
for part in "${parts[@]}"; do
  "print_$part"
done
