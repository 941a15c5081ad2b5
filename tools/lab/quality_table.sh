#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/quality_table.sh [--check]
# Measures surface and chord fields of the demo scene against path-traced references for the tables of README.md, and
# notes the modelled rates of surface fields. With --check it leaves docs/log/data/readme_quality.json alone and fails if
# the figures there differ.
# Scene, seeds, views and samples are fixed, so the figures are the same on every run.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scene=$root/baker/scenes/product.obj
# A row's name and what it bakes. Chord fields: as many origins as directions shows most per byte.
names=("surface, 150 kB" "surface, 250 kB" "surface, 500 kB" "chord, 1024 × 1024" "chord, 2048 × 2048")
options=("--layout surface --paths 100 --fit 150kB" "--layout surface --paths 100 --fit 250kB" "--layout surface --paths 100 --fit 500kB"
  "--origins 1024 --directions 1024 --spp 16"
  "--origins 2048 --directions 2048 --spp 16")
# The fast mode and the good one, for surface fields and for chord fields.
# shellcheck disable=SC2034  # measure_row names them
declare -A fast=([surface]=antialiased [chord]=nearest) good=([surface]=2x2 [chord]=linear)
orbits=("30,20,3" "75,50,3")  # two rings around the clock, one from nearly level, one from above
views=4                   # a ring
reference_spp=256
size=240x240
work=$root/build/quality

draw_rings() {
  local ring
  for ring in "${!orbits[@]}"; do
    "$@" -o "$work/$drawing-$ring.png" --orbit "${orbits[$ring]}" --size "$size" --turntable "$views" >/dev/null
  done
}

trace_references() {
  local drawing=reference
  draw_rings "$lumi" reference "$scene" --spp "$reference_spp"
}

# Mean figures over all views of $drawing.
figures() {
  local ring view picture
  for ring in "${!orbits[@]}"; do
    for ((view = 0; view < views; ++view)); do
      picture=$ring-$(printf '%03d' "$view").png
      "$lumi" compare "$work/$drawing-$picture" "$work/reference-$picture"
    done
  done | mean_figures $((${#orbits[@]} * views))
}

# rates FIELD MODE: modelled frames a second by part, as JSON.
rates() {
  "$lumi" inspect "$1" --screen 240x240 --json | python3 -c 'import json, sys
print(json.dumps({part: round(rate, 1) for part, rate in json.load(sys.stdin)["frames_per_second"][sys.argv[1]].items()}))' "$2"
}

# Row k, into a file of its own.
measure_row() {
  local k=$1 kind mode drawing bake row layout=${names[$1]%%,*}
  local field=$work/$k.lumi
  read -ra bake <<<"${options[$k]}"
  "$lumi" bake "$scene" -o "$field" "${bake[@]}"
  row=(field "${names[$k]}" flash_bytes "$(stat --format=%s "$field")")
  for kind in fast good; do
    declare -n modes=$kind
    mode=${modes[$layout]} drawing=$k-${modes[$layout]}
    draw_rings "$lumi" render "$field" --mode "$mode"
    row+=("$kind" "$(figures)")
  done
  if [[ $layout == surface ]]; then row+=(frames_per_second "$(rates "$field" "${fast[surface]}")"); fi
  json_row "${row[@]}" >"$work/$k.row"
}

main() {
  case ${1:-} in
    '' | --check) ;;
    --help) help "$0" && exit ;;
    *) wrong_call "unknown option '$1'" ;;
  esac
  mkdir -p "$work"
  run_step "Packages" "$root/tools/install_packages.sh" build
  run_step "Build" build_lumi
  run_step "Path-trace references" trace_references
  local k
  for k in "${!names[@]}"; do
    run_step "Measure ${names[$k]}" measure_row "$k"
  done
  printf '\n'
  cat "$work"/[0-9].row | tee "$work/rows.json"
  if [[ ${1:-} != --check ]]; then
    put readme_quality rows <"$work/rows.json"
  else
    while read -r k; do
      grep --quiet --fixed-strings -e "$k" "$root/docs/log/data/readme_quality.json" ||
        die "not in docs/log/data/readme_quality.json: '$k'; run tools/lab/quality_table.sh"
    done <"$work/rows.json"
  fi
}

main "$@"
