#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/soak.sh [--minutes N]
# Draws random frames on an emulated Cortex-M0+, Cortex-M4 and Cortex-M55 at once, so long (a minute if not said): random
# orbits, image sizes, stripes, pixel formats and modes of three surface fields, one of them with see-through parts and
# one with moving ones and light states, and a chord field, with guard zones around every buffer and a painted stack (tests/cross/soak.cpp). Each frame drawn in stripes
# must be the frame drawn whole, by whichever of the two ways it was prepared, on one core or in halves. Sums up what was
# drawn. The first fault ends it and names the seed that shows it again.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

minutes=1
work=$root/build/soak
frames=4000  # frames in a batch; each batch begins with another seed
cpus=(cortex-m0plus cortex-m4 cortex-m55)

parse_arguments() {
  while (($#)); do
    case $1 in
      --minutes) minutes=${2:?"--minutes needs a number"} && shift ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown argument '$1'" ;;
    esac
    shift
  done
}

build_programs() {
  local cpu
  for cpu in "${cpus[@]}"; do
    (cd "$root" && cmake --preset "$cpu" >/dev/null && cmake --build --preset "$cpu" --target lumi_soak)
  done
}

bake_fields() {
  local scene=$root/baker/scenes/product.obj
  [[ -x $lumi ]] || (cd "$root" && cmake --preset release && cmake --build --preset release --target lumi)
  [[ -f $work/surface.lumi ]] || "$lumi" bake "$scene" -o "$work/surface.lumi" --layout surface --fit 60kB --paths 10 --sky gradient
  python3 -B "$root/tools/lab/scenes/write_scenes.py" "$work"
  [[ -f $work/bottle.lumi ]] || "$lumi" bake "$work/bottle.json" -o "$work/bottle.lumi" --layout surface --fit 60kB --paths 10
  [[ -f $work/moving.lumi ]] || "$lumi" bake "$root/baker/scenes/clock.json" -o "$work/moving.lumi" --state glow \
    --fit 60kB --paths 4
  [[ -f $work/chord.lumi ]] ||
    "$lumi" bake "$scene" -o "$work/chord.lumi" --origins 256 --directions 512 --texel rgb565 --spp 2
}

# soak CPU: batches until the minutes are over, their lines into CPU.txt.
soak() {
  local seed
  : >"$work/$1.txt"
  for ((seed = 1; SECONDS < end; ++seed)); do
    cmake -D CPU="$1" -D PROGRAM="$root/build/$1/tests/cross/lumi_soak.elf" -D "ARGUMENTS=$seed;$frames" \
      -D "FIELDS=$work/surface.lumi;$work/chord.lumi;$work/bottle.lumi;$work/moving.lumi" -P "$root/platform/mps2/run.cmake" >>"$work/$1.txt" ||
      die "$1, seed $seed: $(tail -n 1 "$work/$1.txt")"
  done
}

soak_all() {
  local cpu pids=() pid
  end=$((SECONDS + 60 * minutes))
  for cpu in "${cpus[@]}"; do soak "$cpu" & pids+=($!); done
  for pid in "${pids[@]}"; do wait "$pid"; done
}

sum_up() {
  local cpu
  for cpu in "${cpus[@]}"; do
    awk -v cpu="$cpu" -v minutes="$minutes" '
      { frames += $2; refused += $4; stripes += $6; if ($8 > stack) stack = $8 }
      END { printf "{\"cpu\": \"%s\", \"minutes\": %d, \"frames\": %d, \"stripes\": %d, \"refused\": %d, \"stack_bytes\": %d}\n",
        cpu, minutes, frames, stripes, refused, stack }' "$work/$cpu.txt"
  done
}

main() {
  parse_arguments "$@"
  mkdir -p "$work"
  run_step "Fields" bake_fields
  run_step "Build for the boards" build_programs
  run_step "Soak, $minutes minutes" soak_all
  printf '\n'
  sum_up
}

main "$@"
