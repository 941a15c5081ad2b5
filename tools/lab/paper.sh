#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/paper.sh [--minutes MIN] [--views COUNT] [--spp S] [--scene NAME]... [--beam parallel|converging] [--docs] [--quick]
# The evaluation of the LumiPath paper (MICCAI 2019) at its size, on the scenes testcard and product: M = 12,288, of
# which the upper half is kept, N = 24,576, with as many light paths a ray as MIN minutes of all cores allow for all
# scenes together [120; at least 1 path]. COUNT held-out views of the upper half [48] are compared with references of S
# light paths a pixel [128]: nearest, 3×3, 5×5 and 9×9, the first two by spans, too; a surface field beside them; one view with
# more and more background. Then what drawing costs: seconds of a reference, share of time in texel reads, frames a
# second of one and two eyes at the HoloLens's 1268×720 pixels.
# --docs: write docs/log/data/paper.json and the pages, of all scenes measured so far. --quick: tiny lattices, to try it. What lies in
# build/paper is not made again, and a bake that was stopped goes on. With LUMI and LUMI_LAB in the environment those
# programs are taken as they are.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

declare -A scene_files=([testcard]=testcard.obj [product]=product.obj)
all_scenes=(testcard product)
scenes=("${all_scenes[@]}")
origins=12288 cap=50% directions=24576
beam=parallel  # the paper's directions d(i,j), as we read them
minutes=120
surface_budget=150kB surface_paths=60
views=48 reference_spp=128
modes=nearest,linear,paper5,paper9,nearest/8,linear/8
eye_size=(1268 720)
eye_orbit=40,82,6  # every ray enters through the upper half of the sphere
eye_fovs=("33.2 1" "61.5 1/2" "99.9 1/4")  # degrees over the width; what the sphere then fills of the height
probe_shards=512 probe_spp=64  # a bake of one of them tells the speed
work=${LUMI_WORK:-$root/build/paper}

# processor_s FILE COMMAND...: runs COMMAND; its seconds of processor stand in FILE then, whatever else the machine does.
processor_s() {
  local file=$1 TIMEFORMAT='%U'
  shift
  { time "$@" 2>&3; } 3>&2 2>"$file"
}

bake_config() {
  "$lumi" bake "$root/baker/scenes/${scene_files[$1]}" --layout chord --origins "$origins" --cap "$cap" \
    --directions "$directions" --texel rgb565 --beam "$beam" "${@:2}"
}

# Prints how many light paths a ray this scene's share of the minutes allows for. The middle shard stands for all.
choose_spp() {
  processor_s "$work/probe.s" bake_config "$1" -o "$work/probe.lumi" --spp "$probe_spp" \
    --shard "$((probe_shards / 2))/$probe_shards" --restart >/dev/null
  awk -v budget="$((minutes * 60 * $(nproc) / ${#scenes[@]}))" -v shards="$probe_shards" -v spp="$probe_spp" \
    '{ paths = int(budget * spp / ($1 * shards + 1e-9)); print paths < 1 ? 1 : paths }' "$work/probe.s"
  rm -f "$work"/probe.lumi*
}

# Bakes SCENE unless it is there; what it took stands in SCENE.bake.json. The number of light paths is kept, so that a
# bake that was stopped goes on; its seconds are those after the stop.
bake_scene() {
  local scene=$1
  if [[ ! -f $work/$scene.lumi ]]; then
    [[ -f $work/$scene.spp ]] || { choose_spp "$scene" >"$work/$scene.new" && mv "$work/$scene.new" "$work/$scene.spp"; }
    processor_s "$work/$scene.bake_s" bake_config "$scene" -o "$work/$scene.lumi" --spp "$(<"$work/$scene.spp")"
    printf '{"spp": %d, "minutes": %d, "processor_s": %.0f, "beam": "%s"}\n' "$(<"$work/$scene.spp")" "$minutes" \
      "$(<"$work/$scene.bake_s")" "$beam" >"$work/$scene.bake.json"
  fi
  [[ -f $work/$scene-surface.lumi ]] || "$lumi" bake "$root/baker/scenes/${scene_files[$scene]}" \
    -o "$work/$scene-surface.lumi" --layout surface --paths "$surface_paths" --fit "$surface_budget"
}

# Measures how the background around a small object changes likeness: SCENE.background.json has the figures of `lumi
# compare` for each share.
measure_background() {
  local scene=$1 size=${eye_size[0]}x${eye_size[1]} fov share separator=
  {
    printf '['
    for fov in "${eye_fovs[@]}"; do
      read -r fov share <<<"$fov"
      "$lumi" reference "$root/baker/scenes/${scene_files[$scene]}" -o "$work/truth.png" --spp "$reference_spp" \
        --orbit "$eye_orbit" --size "$size" --fov "$fov" >/dev/null
      "$lumi" render "$work/$scene.lumi" -o "$work/drawn.png" --mode paper --orbit "$eye_orbit" --size "$size" \
        --fov "$fov" --background black >/dev/null
      printf '%s{"share": "%s"' "$separator" "$share"
      "$lumi" compare "$work/drawn.png" "$work/truth.png" | awk '{ printf ", \"%s\": %s", $1, $2 }'
      printf '}'
      separator=,
    done
    printf ']\n'
  } >"$work/$scene.new"
  mv "$work/$scene.new" "$work/$scene.background.json"
}

measure_scene() {
  local scene=$1
  bake_scene "$scene"
  [[ -f $work/$scene.report.json ]] || {
    "$lumi" report "$root/baker/scenes/${scene_files[$scene]}" "$work/$scene.lumi" "$work/$scene-surface.lumi" \
      --views upper --count "$views" --spp "$reference_spp" --cache "$work/cache" --mode "$modes" --json \
      >"$work/$scene.new" && mv "$work/$scene.new" "$work/$scene.report.json"
  }
  [[ -f $work/$scene.background.json ]] || measure_background "$scene"
  [[ -f $work/$scene.reference_s ]] || {
    processor_s "$work/$scene.new" "$lumi" reference "$root/baker/scenes/${scene_files[$scene]}" -o "$work/timed.png" \
      --spp "$reference_spp" >/dev/null && mv "$work/$scene.new" "$work/$scene.reference_s"
  }
  [[ -f $work/$scene.draw.json ]] || {
    "$lab" draw "$work/$scene.lumi" "${eye_size[@]}" >"$work/$scene.new" && mv "$work/$scene.new" "$work/$scene.draw.json"
  }
}

main() {
  local chosen=() docs=false quick=false scene
  while (($#)); do
    case $1 in
      --minutes) minutes=${2:?"--minutes needs a number"} && shift ;;
      --views) views=${2:?"--views needs a number"} && shift ;;
      --spp) reference_spp=${2:?"--spp needs a number"} && shift ;;
      --scene) chosen+=("${2:?"--scene needs a name"}") && shift ;;
      --beam) beam=${2:?"--beam needs a word"} && shift ;;
      --docs) docs=true ;;
      --quick) origins=256 directions=512 minutes=0 views=1 reference_spp=1 surface_budget=60kB surface_paths=4 \
        eye_size=(64 48) probe_shards=2 probe_spp=1 work=$root/build/paper-quick scenes=(testcard) quick=true ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  [[ $minutes =~ ^[0-9]+$ ]] || wrong_call "--minutes takes a whole number, not '$minutes'"
  if ((${#chosen[@]})); then scenes=("${chosen[@]}"); fi
  for scene in "${scenes[@]}"; do [[ -n ${scene_files[$scene]:-} ]] || wrong_call "there is no scene '$scene'"; done
  if $quick; then rm -rf "$work"; fi
  mkdir -p "$work"
  [[ -n ${LUMI:-} ]] || run_step "Build" build_lumi
  [[ -n ${LUMI_LAB:-} ]] || run_step "Build the laboratory" build_lab
  for scene in "${scenes[@]}"; do run_step "Measure the $scene" measure_scene "$scene"; done
  python3 -B "$root/tools/lab/pages.py" "$($docs && echo collect || echo show)" paper "$work"
  print_step_times
}

main "$@"
