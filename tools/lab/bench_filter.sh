#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/bench_filter.sh [--docs] NAME=FIELD...
# Trains a filter for each field of the desk clock, unless build/filter/NAME.filter is there, judges it on the views of
# `lumi report`, and prints rows. --docs also writes them and the page docs/log/filter.md. LUMI_TRAIN and LUMI_JUDGE hold further
# options of the two commands. A training takes about ten minutes of CPU. With LUMI in the environment that program is
# taken as it is.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scene=$root/baker/scenes/product.obj
work=$root/build/filter
docs=no
fields=()

parse_arguments() {
  while (($# > 0)); do
    case $1 in
      --docs) docs=yes ;;
      --help) help "$0" && exit ;;
      *=*) fields+=("$1") ;;
      *) wrong_call "say NAME=FIELD, not '$1'" ;;
    esac
    shift
  done
  ((${#fields[@]} > 0)) || wrong_call "name at least one field"
}

# measure NAME FIELD: leaves NAME.filter and NAME.json.
measure() {
  local options
  read -ra options <<<"${LUMI_TRAIN:-}"
  [[ -f $work/$1.filter ]] || "$lumi" filter train "$2" "$scene" -o "$work/$1.filter" --cache "$work/truths" "${options[@]}"
  read -ra options <<<"${LUMI_JUDGE:-}"
  "$lumi" filter judge "$work/$1.filter" "$2" "$scene" --json --cache "$work/truths" "${options[@]}" >"$work/$1.json"
}

# A row of the drawn pictures of each field, and one of the filtered ones.
print_rows() {
  local field name
  for field in "${fields[@]}"; do
    name=${field%%=*}
    python3 -c 'import json, sys
name, verdict, size = sys.argv[1], json.load(open(sys.argv[2])), int(sys.argv[3])
print(json.dumps({"picture": name, "bytes": size, **verdict["drawn"]}))
print(json.dumps({"picture": name + ", filtered", **verdict["filtered"], "worse": verdict["worse"]}))' \
      "$name" "$work/$name.json" "$(stat --format=%s "${field#*=}")"
  done
}

main() {
  parse_arguments "$@"
  mkdir -p "$work"
  local field
  for field in "${fields[@]}"; do measure "${field%%=*}" "${field#*=}"; done
  print_rows | tee "$work/rows.json"
  if [[ $docs == yes ]]; then put filter rows <"$work/rows.json"; fi
}

main "$@"
