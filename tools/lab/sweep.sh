#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/sweep.sh [--scene NAME]... [--no-cost] [--docs] [--quick]
# The trade of a chord field, against path-traced references: lattices M × N, texel formats, reconstructions, and the
# paper's K neighbours, on the scenes product, testcard and finishes; surface fields beside them. Then what a pixel costs
# on a Cortex-M4 for lattices of 256 to 65,536 points. --scene: that one alone (may be repeated). --no-cost: leave the
# last part out. --docs: write docs/log/data/sweep.json and the pages, of all that was measured so far. --quick: one
# small lattice of one scene, to try it. Whatever lies in build/sweep is not made again. With LUMI and LUMI_LAB in the
# environment those programs are taken as they are. Scenes, seeds and views are fixed, so the figures are the same on
# every run.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

declare -A scene_files=([product]=product.obj [testcard]=testcard.obj [finishes]=finishes.json)
all_scenes=(product testcard finishes)
scenes=("${all_scenes[@]}")
lattices=(256x256 256x1024 512x512 1024x256 512x2048 1024x1024 2048x512 2048x2048)  # MxN, with palette8 texels
texel_lattices=(512x512 1024x1024)                                                 # with every other format, too
texels=(rgb888 rgb565 luma8)
kernel_lattice=1024x1024  # for the paper's K = 1 to 9
surface_budgets=(150kB 500kB)
surface_paths=60  # light paths a texel
spp=8             # light paths a ray of chord fields
reference_spp=64
views=4
cost_lattices=(256x256 1024x256 4096x256 16384x256 65536x128 256x1024 256x4096 256x16384 128x65536)
work=$root/build/sweep

# bake_chord SCENE MxN TEXEL: unless it is there.
bake_chord() {
  local field=$work/$1-$2-$3.lumi
  [[ -f $field ]] || "$lumi" bake "$root/baker/scenes/${scene_files[$1]}" -o "$field" --layout chord \
    --origins "${2%x*}" --directions "${2#*x}" --texel "$3" --spp "$spp"
}

bake_scene() {
  local scene=$1 lattice texel budget
  for lattice in "${lattices[@]}"; do bake_chord "$scene" "$lattice" palette8; done
  for lattice in "${texel_lattices[@]}"; do
    for texel in "${texels[@]}"; do bake_chord "$scene" "$lattice" "$texel"; done
  done
  for budget in "${surface_budgets[@]}"; do
    [[ -f $work/$scene-$budget.lumi ]] || "$lumi" bake "$root/baker/scenes/${scene_files[$scene]}" \
      -o "$work/$scene-$budget.lumi" --layout surface --paths "$surface_paths" --fit "$budget"
  done
}

# report SCENE NAME MODES FIELD...: into NAME.json, unless it is there.
report() {
  local scene=$1 name=$2 modes=$3
  shift 3
  [[ -f $work/$name.json ]] || {
    "$lumi" report "$root/baker/scenes/${scene_files[$scene]}" "$@" --count "$views" --spp "$reference_spp" \
      --cache "$work/cache" --mode "$modes" --json >"$work/$name.new" && mv "$work/$name.new" "$work/$name.json"
  }
}

measure_scene() {
  local scene=$1 field
  bake_scene "$scene"
  for field in "$work/$scene"-*.lumi; do
    report "$scene" "$(basename "$field" .lumi).report" nearest,paper5 "$field"
  done
  if [[ -f $work/$scene-$kernel_lattice-palette8.lumi ]]; then
    report "$scene" "$scene.kernel" "$(echo paper{1..9} | tr ' ' ,)" "$work/$scene-$kernel_lattice-palette8.lumi"
  fi
}

# Instructions a pixel on a Cortex-M4 with that lattice.
count_instructions() {
  local lattice
  for lattice in "${cost_lattices[@]}"; do
    [[ -f $work/$lattice.cost.json ]] || "$lab" bench --core m4 --mode nearest,linear --texel palette8 --span 0,16 \
      --view generic --origins "${lattice%x*}" --directions "${lattice#*x}" --spp 1 --work "$work/bench" \
      --json "$work/$lattice.cost.json" >/dev/null
  done
}

main() {
  local chosen=() costs=true docs=false quick=false
  while (($#)); do
    case $1 in
      --scene) chosen+=("${2:?"--scene needs a name"}") && shift ;;
      --no-cost) costs=false ;;
      --docs) docs=true ;;
      --quick) scenes=(testcard) lattices=(64x64) texel_lattices=() kernel_lattice=64x64 surface_budgets=() views=1 \
        spp=1 reference_spp=1 work=$root/build/sweep-quick costs=false quick=true ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  if ((${#chosen[@]})); then scenes=("${chosen[@]}"); fi
  local scene
  for scene in "${scenes[@]}"; do [[ -n ${scene_files[$scene]:-} ]] || wrong_call "there is no scene '$scene'"; done
  if $quick; then rm -rf "$work"; fi
  mkdir -p "$work"
  [[ -n ${LUMI:-} ]] || run_step "Build" build_lumi
  for scene in "${scenes[@]}"; do run_step "Measure the $scene" measure_scene "$scene"; done
  if $costs; then
    [[ -n ${LUMI_LAB:-} ]] || run_step "Build the laboratory" build_lab
    run_step "Count instructions" count_instructions
  fi
  python3 -B "$root/tools/lab/pages.py" "$($docs && echo collect || echo show)" sweep "$work"
  print_step_times
}

main "$@"
