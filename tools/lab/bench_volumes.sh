#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/bench_volumes.sh [--docs] [--quick] [--scene NAME]...
# Measures chord against surface fields of volumes at equal bytes: smoke (docs/examples), a head from MRI (Debian's
# mricron-data) and a skull from CT (Debian's invesalius-examples), each by a grid and a transfer function. Pictures are
# compared with path-traced ones over a grey background. --quick: smoke at its smallest size, few samples. --scene: that
# one alone (may be repeated). --docs: write the table of all scenes that were measured into docs/log/volumes.md.
# What is fetched lands in build/volumes and is never committed. Fields and references that are there are not made
# again. Scenes, seeds and views are fixed, so the figures are the same on every run. With LUMI in the environment that
# program is taken as it is, and nothing is built. Needs python3; head and skull also apt-get and a network.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

all_scenes=(smoke head skull)
scenes=("${all_scenes[@]}")
budgets=(60kB 250kB)
paths=10   # light paths a texel of surface fields
spp=16     # light paths a texel of chord fields
reference_spp=128
orbits=("10,12,3" "70,40,3")  # two rings
views=2                       # a ring
size=120x120
background=808080
work=$root/build/volumes

fetch() {
  [[ -d $work/$1/usr ]] ||
    (mkdir -p "$work/$1" && cd "$work/$1" && apt-get download --quiet "$1" && dpkg-deb --extract ./*.deb .)
}

# Studio light from the front and above; bone and skin by density alone.
write_scan() {
  cat >"$work/$1.json" <<SCENE
{"up": "z",
 "volume": {"file": "$1.nii.gz", "transfer": [$2]},
 "lights": [{"type": "directional", "direction": [-0.6, -1, -0.7], "irradiance": [3, 2.9, 2.7]}],
 "environment": {"zenith": 0.7, "horizon": [0.35, 0.36, 0.4], "nadir": 0.15}}
SCENE
}

make_scene() {
  [[ ! -f $work/$1.json ]] || return 0
  case $1 in
    smoke)
      python3 "$root/docs/examples/smoke.py" "$work/smoke.nii.gz"
      cp "$root/docs/examples/smoke.json" "$work/smoke.json"
      ;;
    head)
      fetch mricron-data
      cp "$work/mricron-data/usr/share/mricron/templates/ch2.nii.gz" "$work/head.nii.gz"
      write_scan head '{"value": 35, "density": 0, "colour": [0.9, 0.6, 0.5]},
        {"value": 70, "density": 0.15, "colour": [0.9, 0.65, 0.55]},
        {"value": 120, "density": 0.6, "colour": [0.9, 0.8, 0.72]}'
      ;;
    skull)
      fetch invesalius-examples
      python3 "$root/tools/lab/scenes/write_skull.py" \
        "$work/invesalius-examples/usr/share/doc/invesalius-examples/examples/Cranium.inv3" "$work"
      write_scan skull '{"value": 150, "density": 0, "colour": [0.8, 0.6, 0.45]},
        {"value": 350, "density": 0.8, "colour": [0.88, 0.82, 0.7]},
        {"value": 1000, "density": 3, "colour": [0.93, 0.91, 0.86]}'
      ;;
  esac
}

# rings PICTURE COMMAND...: the command's views as $work/PICTURE-RING-000.png and so on, unless they are there.
rings() {
  local picture=$work/$1 ring
  for ring in "${!orbits[@]}"; do
    [[ -f $picture-$ring-000.png ]] || "${@:2}" -o "$picture-$ring.png" --orbit "${orbits[$ring]}" --size "$size" \
      --turntable "$views" --background "$background" >/dev/null
  done
}

# figures SCENE PICTURE: means over all views.
figures() {
  local ring view name
  for ring in "${!orbits[@]}"; do
    for ((view = 0; view < views; ++view)); do
      name=$ring-$(printf '%03d' "$view").png
      "$lumi" compare "$work/$2-$name" "$work/$1-truth-$name"
    done
  done | mean_figures $((${#orbits[@]} * views))
}

# row SCENE BUDGET LAYOUT MODE [OPTION...]: bakes, draws, measures.
row() {
  local scene=$1 budget=$2 layout=$3 mode=$4 name=$1-$2-$3
  [[ -f $work/$name.lumi ]] || "$lumi" bake "$work/$scene.json" -o "$work/$name.lumi" --layout "$layout" --fit "$budget" \
    "${@:5}"
  rings "$name" "$lumi" render "$work/$name.lumi" --mode "$mode"
  json_row scene "$scene" layout "$layout" mode "$mode" flash_bytes "$(stat --format=%s "$work/$name.lumi")" \
    figures "$(figures "$scene" "$name")" >"$work/$name.row"
}

# What --layout auto takes and why; the bake itself is stopped before it starts.
choice() {
  "$lumi" bake "$work/$1.json" -o "$work/$1-plan.lumi" --fit "${budgets[0]}" --plan-only 2>&1 | grep '^layout' | head -1 >"$work/$1.choice"
}

measure() {
  local scene=$1 budget
  make_scene "$scene"
  rings "$scene-truth" "$lumi" reference "$work/$scene.json" --spp "$reference_spp"
  choice "$scene"
  for budget in "${budgets[@]}"; do
    row "$scene" "$budget" chord linear --spp "$spp"
    row "$scene" "$budget" surface 2x2 --paths "$paths"
  done
}

print_rows() {
  local scene budget layout
  for scene in "${all_scenes[@]}"; do
    for budget in "${budgets[@]}"; do
      for layout in chord surface; do
        [[ ! -f $work/$scene-$budget-$layout.row ]] || cat "$work/$scene-$budget-$layout.row"
      done
    done
  done
}

print_choices() {
  local scene
  for scene in "${all_scenes[@]}"; do
    [[ ! -f $work/$scene.choice ]] || json_row scene "$scene" choice "$(cat "$work/$scene.choice")"
  done
}

main() {
  local to_docs= chosen=()
  while (($#)); do
    case $1 in
      --docs) to_docs=1 ;;
      --quick) scenes=(smoke) budgets=(60kB) reference_spp=16 spp=8 paths=20 views=1 size=80x80 work=$work/quick ;;
      --scene) chosen+=("${2:?--scene takes a name}") && shift ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  if [[ -n $to_docs && $work == */quick ]]; then wrong_call "--quick measures too little for --docs"; fi
  ((${#chosen[@]} == 0)) || scenes=("${chosen[@]}")
  mkdir -p "$work"
  [[ -n ${LUMI:-} ]] || run_step "Build" build_lumi
  local scene
  for scene in "${scenes[@]}"; do
    run_step "Measure $scene" measure "$scene"
  done
  printf '\n'
  print_rows
  print_choices
  if [[ -n $to_docs ]]; then
    print_rows | put volumes rows
    print_choices | put volumes choices
  fi
}

main "$@"
