#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/quality_table.sh [--check]
# Measures surface and chord fields of the demo scene against path-traced references and writes the table of README.md,
# between its two marker comments. With --check it leaves README.md alone and fails if the table there differs.
# Scene, seeds, views and samples are fixed, so the figures are the same on every run.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

scene=$root/baker/scenes/product.obj
# A row's name and what it bakes. Chord fields: as many origins as directions shows most per byte.
names=("surface, 150 kB" "surface, 250 kB" "surface, 500 kB" "chord, 1024 × 1024" "chord, 2048 × 2048")
options=("--layout surface --paths 100 --fit 150kB" "--layout surface --paths 100 --fit 250kB" "--layout surface --paths 100 --fit 500kB"
  "--origins 1024 --directions 1024 --spp 16"
  "--origins 2048 --directions 2048 --spp 16")
# Of surface and of chord fields: the fast mode and the good one.
declare -A fast=([surface]=antialiased [chord]=nearest) good=([surface]=2x2 [chord]=linear)
orbits=("30,20,3" "75,50,3")  # two rings around the clock, one from nearly level, one from above
views=4                   # a ring
reference_spp=256
size=240x240
lumi=$root/build/release/tools/lumi
readme=$root/README.md
begin_marker='<!-- quality table: begin (tools/lab/quality_table.sh) -->'
end_marker='<!-- quality table: end -->'
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

# Mean PSNR and SSIM over all views of $drawing, as cells of a table.
mean_figures() {
  local ring view picture
  for ring in "${!orbits[@]}"; do
    for ((view = 0; view < views; ++view)); do
      picture=$ring-$(printf '%03d' "$view").png
      "$lumi" compare "$work/$drawing-$picture" "$work/reference-$picture"
    done
  done | awk -v count=$((${#orbits[@]} * views)) '{ sum[$1] += $2 }
    END { printf " %.1f dB / %.3f |", sum["PSNR"] / count, sum["SSIM"] / count }'
}

# Row k, printed to a file of its own.
measure_row() {
  local k=$1 mode drawing bake layout=${names[$1]%%,*}
  local field=$work/$k.lumi
  read -ra bake <<<"${options[$k]}"
  "$lumi" bake "$scene" -o "$field" "${bake[@]}"
  {
    printf '| %s | %s |' "${names[$k]}" "$(stat --format=%s "$field" | awk '{ printf "%.2f MB", $1 / 1e6 }')"
    for mode in "${fast[$layout]}" "${good[$layout]}"; do
      drawing=$k-$mode
      draw_rings "$lumi" render "$field" --mode "$mode"
      mean_figures
    done
    printf '\n'
  } >"$work/$k.row"
}

print_table() {
  local k
  printf '| field | flash | antialiased; nearest | 2×2; linear |\n|---|---|---|---|\n'
  for k in "${!names[@]}"; do
    cat "$work/$k.row"
  done
  printf '\nMeans over %d views of %s. Surface fields have 100 light paths a texel, chord fields 16 and a byte a texel;\n' \
    $((${#orbits[@]} * views)) "$size"
  printf 'references with %d samples a pixel.\n' "$reference_spp"
}

table_in_readme() {
  awk -v begin="$begin_marker" -v end="$end_marker" '$0 == end { inside = 0 } inside { print } $0 == begin { inside = 1 }' \
    "$readme"
}

main() {
  case ${1:-} in
    '' | --check) ;;
    --help) help "$0" && exit ;;
    *) wrong_call "unknown option '$1'" ;;
  esac
  check_markers "$readme" "$begin_marker" "$end_marker"
  mkdir -p "$work"
  run_step "Packages" "$root/tools/install_packages.sh" build
  run_step "Build" build_lumi
  run_step "Path-trace references" trace_references
  local k
  for k in "${!names[@]}"; do
    run_step "Measure ${names[$k]}" measure_row "$k"
  done
  print_table >"$work/table.md"
  printf '\n'
  cat "$work/table.md"
  if [[ ${1:-} != --check ]]; then
    replace_between "$readme" "$begin_marker" "$end_marker" "$work/table.md"
    printf '\nREADME.md holds this table now.\n'
  elif diff -u <(table_in_readme) "$work/table.md"; then
    printf '\nThe table in README.md is current.\n'
  else
    die "the table in README.md is out of date: run tools/lab/quality_table.sh and commit README.md"
  fi
}

main "$@"
