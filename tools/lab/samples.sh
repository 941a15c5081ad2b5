#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/samples.sh [--object NAME]... [--size KB]... [OUT]
# Bakes the sample fields that a release holds, NAMEKB.lumi: the clock, the watch and the potion of docs/gallery at 30, 120
# and 250 kB; tools/packaging/release.py --samples OUT packs them. --object skull also works, by a CT that Debian has
# (scenes/fetch_skull.sh); its licence is GPL-2, so that no release under our licence holds a field of it.
# Fields that lie in OUT (build/samples) are not baked again: remove one to bake it anew.
# With LUMI in the environment that program is taken as it is, and nothing is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

objects=(clock watch potion) sizes=(30 120 250)
out=$root/build/samples
scene_folder=$root/build/gallery/scenes

parse_arguments() {
  local chosen=() chosen_sizes=()
  while (($#)); do
    case $1 in
      --object) chosen+=("${2:?"--object needs a name"}") && shift ;;
      --size) chosen_sizes+=("${2:?"--size needs a number of kilobytes"}") && shift ;;
      --help) help "$0" && exit ;;
      -*) wrong_call "unknown option '$1'" ;;
      *) out=$1 ;;
    esac
    shift
  done
  if ((${#chosen[@]})); then objects=("${chosen[@]}"); fi
  if ((${#chosen_sizes[@]})); then sizes=("${chosen_sizes[@]}"); fi
}

write_scene() {
  [[ -f $scene_folder/$1.json ]] || python3 -B "$root/tools/lab/gallery/objects.py" "$scene_folder"
  [[ -f $scene_folder/$1.json ]] || wrong_call "there is no object '$1'"
  [[ $1 != skull || -f $scene_folder/skull.nii.gz ]] ||
    { "$root/tools/lab/scenes/fetch_skull.sh" "$scene_folder/../ct" && mv "$scene_folder/../ct/skull.nii.gz" "$scene_folder"; }
}

bake() {
  [[ -f $out/$1$2.lumi ]] || "$lumi" bake "$scene_folder/$1.json" -o "$out/$1$2.lumi" --layout surface --fit "${2}kB"
}

main() {
  local name size
  parse_arguments "$@"
  mkdir -p "$scene_folder" "$out"
  if [[ -z ${LUMI:-} ]]; then run_step "Build" build_lumi; fi
  for name in "${objects[@]}"; do
    write_scene "$name"
    for size in "${sizes[@]}"; do run_step "Bake $name, $size kB" bake "$name" "$size"; done
  done
  print_step_times
}

main "$@"
