#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/figures.sh [--check | --try] [--paper-minutes N] [STAGE...]
# Measures every figure, table and picture of README and docs anew, of one commit, in about 67 minutes of two quiet
# cores. The commit is the last one that changed code. A stage whose data in docs/log/data bear it already is left out,
# so a stop loses one stage at most. docs/log/data/measured.json says commit and day at the end.
#   --check  measures nothing; fails where a page shows other figures than the data, or data are of two commits
#   --try    tries the stages with tiny parameters, in build/figures-try; nothing of docs changes
#   --paper-minutes  time of the bake of the paper's size [10]; the more, the less noise
#   STAGE    one of them: licences, devices, bench, trade, pictures, paper
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

data=$root/docs/log/data
code=(core baker platform tools toolchains ':!tools/lab/pages.py' ':!tools/lab/figures' ':!*.md')
stages=(licences devices bench trade pictures paper)
declare -A minutes=([licences]=1 [devices]=8 [bench]=10 [trade]=13 [pictures]=17 [paper]=18)
declare -A data_of=([licences]=licences [devices]=devices [bench]=tradeoff [trade]=trade [pictures]=scenes
  [paper]=paper)
paper_minutes=10
try=''

run_licences() {
  python3 -B "$root/tools/packaging/libraries.py" "$lumi" | put licences rows
}

run_devices() {
  cmake --build "$root/build/release" --parallel "$jobs" --target lumi_device_picture
  LUMI_MEASURED=incomplete "$root/tools/lab/devices.sh" --built --docs
  LUMI_MEASURED=incomplete "$root/tools/lab/board_memory.sh"
  sed -i "s/\"incomplete\"/\"$LUMI_MEASURED\"/" "$data/devices.json"
}

run_bench() {
  "$lab" bench --core m0plus,m4 --span 0,4,8,16 --view generic,pole --pixel rgb565 --work "$work/bench" --docs
}

run_trade() {
  python3 -B "$root/tools/lab/proof/trade.py" --docs --work "$work/trade"
}

run_pictures() {
  LUMI_WORK=$work/pictures "$root/tools/lab/pictures.sh"
}

run_paper() {
  LUMI_WORK=$work/paper "$root/tools/lab/paper.sh" --scene product --minutes "$paper_minutes" --views 24 --docs
}

# Each try_STAGE does little work and writes nothing into docs.
try_licences() { python3 -B "$root/tools/packaging/libraries.py" "$lumi" >"$work/licences.json"; }
try_devices() { "$root/tools/lab/devices.sh" --built --only riscv; }
try_bench() {
  "$lab" bench --core m4 --mode nearest,one-sample --texel rgb565 --span 0,16 --view generic --pixel rgb565 \
    --origins 64 --directions 64 --spp 1 --work "$work/bench"
}
try_trade() { python3 -B "$root/tools/lab/proof/trade.py" --quick --work "$work/trade" >"$work/trade.json"; }
try_pictures() {
  "$lumi" reference "$root/baker/scenes/cornell.obj" -o "$work/cornell.png" --size 32x32 --spp 4 >/dev/null
}
try_paper() { "$root/tools/lab/paper.sh" --quick; }

bears() {
  [[ -f $data/$1.json ]] && grep --quiet "\"commit\": \"$LUMI_MEASURED\"" "$data/$1.json"
}

# measure STAGE: unless its data bear the commit. Says how many minutes the stages after it may take.
measure() {
  local stage=$1 left=0 other
  for other in "${chosen[@]}"; do
    bears "${data_of[$other]}" || left=$((left + minutes[$other]))
  done
  if bears "${data_of[$stage]}"; then
    echo "$stage: of $LUMI_MEASURED already"
    return
  fi
  printf '\n== %s, about %d minutes; %d minutes are left\n' "$stage" "${minutes[$stage]}" "$left"
  run_step "$stage" "run_$stage"
}

main() {
  local stage chosen=()
  while (($#)); do
    case $1 in
      --check) exec python3 -B "$root/tools/lab/pages.py" --check ;;
      --try) try=yes ;;
      --paper-minutes) paper_minutes=${2:?"--paper-minutes needs a number"} && shift ;;
      --help) help "$0" && exit ;;
      *) [[ -n ${minutes[$1]:-} ]] || wrong_call "there is no stage '$1'" && chosen+=("$1") ;;
    esac
    shift
  done
  ((${#chosen[@]})) || chosen=("${stages[@]}")
  [[ -z $try ]] || {
    work=$root/build/figures-try && mkdir -p "$work"
    for stage in "${chosen[@]}"; do run_step "$stage" "try_$stage"; done
    print_step_times && exit
  }
  git -C "$root" diff --quiet HEAD -- "${code[@]}" ||
    die "code has changes that are not committed; figures are of a commit"
  LUMI_MEASURED=$(git -C "$root" log -1 --format=%h --abbrev=10 -- "${code[@]}")
  export LUMI_MEASURED
  work=$root/build/figures/$LUMI_MEASURED
  mkdir -p "$work"
  run_step "Packages" "$root/tools/install_packages.sh" tests
  run_step "Configure" cmake --preset host
  run_step "Build" cmake --build "$root/build/release" --parallel "$jobs" --target lumi lumi-lab
  for stage in "${chosen[@]}"; do measure "$stage"; done
  for stage in "${stages[@]}"; do bears "${data_of[$stage]}" || return 0; done
  printf '{\n "commit": "%s",\n "date": "%s"\n}\n' "$LUMI_MEASURED" "$(date +%F)" >"$data/measured.json"
  python3 -B "$root/tools/lab/pages.py" --plots
  print_step_times
}

main "$@"
