#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/bench_quality.sh [--quick] [--docs] [--paths P] [--spp S] [--scene NAME]... [--budget SIZE]...
# Measures how good pictures are for the flash they take, from 12 held-out views against path-traced references: surface
# fields in their three modes and without view dependence, chord fields of a byte a texel, sprites and JPEG sprites of
# the same size, and one exact ray a pixel; and once more on a turntable, where sprites are at their best.
# --quick: the clock at 0.25 MB only. --scene, --budget: that one alone (may be repeated). --paths: light paths a texel of
# surface fields [300]. --spp: light paths a pixel of references [256]; half as many on the turntable. --docs: write
# docs/log/data/quality.json and the pages; scenes that were not measured keep their rows.
# Fields and references that are there are not made again. Scenes, seeds and views are fixed, so the figures are the
# same on every run. With LUMI in the environment that program is taken as it is, and nothing is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

all_scenes=(product finishes gallery)
scenes=("${all_scenes[@]}")
declare -A budgets=(
  [product]='150kB 250kB 500kB 1MB'
  [finishes]='300kB 600kB'
  [gallery]='550kB')
turntable_budget=1  # which of these, from 0 on, stands on the turntable too, and without view dependence; or the last
paths=300           # light paths a texel
reference_spp=256
work=$root/build/quality-bench

# Sets `file`.
scene_file() {
  case $1 in
    product) file=$root/baker/scenes/product.obj ;;
    *) file=$root/baker/scenes/$1.json ;;
  esac
}

# bake_field FIELD BUDGET [OPTION...]: unless it is there.
bake_field() {
  [[ -f $1 ]] || "$lumi" bake "$file" -o "$1" --layout surface --paths "$paths" --fit "${@:2}"
}

# count_instructions FIELD: of frames of this very file, into FIELD.bench.json.
count_instructions() {
  [[ -f $1.bench.json ]] || "$lab" bench --field "$1" --core m4,m0plus --view generic --work "$work/bench" \
    --json "$1.bench.json" >/dev/null
}

# measure_scene NAME: bakes its fields and reports them.
measure_scene() {
  local scene=$1 budget file budgets_of fields=() mean turntable
  scene_file "$scene"
  read -ra budgets_of <<<"${budgets[$scene]}"
  for budget in "${budgets_of[@]}"; do
    fields+=("$work/$scene-$budget-$paths.lumi")
    bake_field "${fields[-1]}" "$budget"
    count_instructions "${fields[-1]}"
  done
  budget=${budgets_of[turntable_budget]:-${budgets_of[-1]}}
  mean=$work/$scene-$budget-$paths-mean.lumi turntable=$work/$scene-$budget-$paths.lumi
  bake_field "$mean" "$budget" --no-view-tables
  local report=("$lumi" report "$file" --cache "$work/cache")
  "${report[@]}" "${fields[@]}" "$mean" --spp "$reference_spp" -o "$work/$scene.html" \
    --json >"$work/$scene.report.json"
  local others=("$lab" baselines "$file" --bytes "$(stat --format=%s "$turntable")" --cache "$work/cache")
  "${others[@]}" --spp "$reference_spp" >"$work/$scene.others.json"
  "${report[@]}" "$turntable" --spp $((reference_spp / 2)) --views ring -o "$work/$scene.ring.html" \
    --json >"$work/$scene.ring.json"
  "${others[@]}" --spp $((reference_spp / 2)) --views ring >"$work/$scene.ring-others.json"
}

main() {
  local write_docs=false chosen=() sizes=''
  while (($#)); do
    case $1 in
      --quick) scenes=(product) budgets[product]=250kB ;;
      --budget) sizes+=" ${2:?"--budget needs a size"}" && shift ;;
      --spp) reference_spp=${2:?"--spp needs a number"} && shift ;;
      --paths) paths=${2:?"--paths needs a number"} && shift ;;
      --scene) chosen+=("${2:?"--scene needs a name"}") && shift ;;
      --docs) write_docs=true ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  if ((${#chosen[@]})); then scenes=("${chosen[@]}"); fi
  local scene
  if [[ -n $sizes ]]; then
    for scene in "${scenes[@]}"; do budgets[$scene]=$sizes; done
  fi
  mkdir -p "$work"
  run_step "Packages" "$root/tools/install_packages.sh" build
  [[ -n ${LUMI:-} ]] || run_step "Build" build_lumi
  [[ -n ${LUMI_LAB:-} ]] || run_step "Build the laboratory" build_lab
  for scene in "${scenes[@]}"; do run_step "Measure the $scene" measure_scene "$scene"; done
  python3 -B "$root/tools/lab/pages.py" "$($write_docs && echo collect || echo show)" quality "$work" "${all_scenes[@]}"
  print_step_times
}

main "$@"
