#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/bench_filter.sh [--docs] NAME=FIELD...
# Trains a filter for each field of the desk clock, unless build/filter/NAME.filter is there, judges it on the views of
# `lumi report`, and prints a table. --docs also writes it to docs/log/filter.md. LUMI_TRAIN and LUMI_JUDGE hold further
# options of the two commands. A training takes about ten minutes of CPU. With LUMI in the environment that program is
# taken as it is.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

scene=$root/baker/scenes/product.obj
work=$root/build/filter
lumi=${LUMI:-$root/build/release/tools/lumi}
page=$root/docs/log/filter.md
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
  "$lumi" filter judge "$work/$1.filter" "$2" "$scene" --json "$work/$1.json" --cache "$work/truths" "${options[@]}"
}

write_table() {
  python3 - "$work" "$page" "$docs" "${fields[@]}" <<'PYTHON'
import json, os, sys

work, page, docs, *fields = sys.argv[1:]
BEGIN, END = "<!-- by tools/lab/bench_filter.sh -->\n", "<!-- end -->\n"


def row(title, size, figures, worse=None):
    cells = [title, size, "%.2f" % figures["psnr_db"], "%.2f" % figures["mask_psnr_db"]]
    for key, name in (("ssim", "ssim"), ("cw_ssim", "cw_ssim"), ("flip", "flip")):
        cells.append("%.4f" % figures[key] + (" (%d)" % worse[name] if worse else ""))
    return "| " + " | ".join(cells) + " |\n"


table = "| picture | bytes | PSNR, dB | covered part | SSIM | CW-SSIM | FLIP (less is better) |\n|---|---:|---|---|---|---|---|\n"
for field in fields:
    name, path = field.split("=", 1)
    verdict = json.load(open(os.path.join(work, name + ".json")))
    size = "{:,}".format(os.path.getsize(path))
    table += row(name, size, verdict["drawn"])
    table += row(name + ", filtered", "", verdict["filtered"], verdict["worse"])
table += "\nIn brackets: of %d views, those in which filtering makes it worse.\n" % verdict["views"]
print(table, end="")
if docs == "yes":
    text = open(page).read()
    before, rest = text.split(BEGIN)
    open(page, "w").write(before + BEGIN + table + END + rest.split(END, 1)[1])
PYTHON
}

main() {
  parse_arguments "$@"
  mkdir -p "$work"
  local field
  for field in "${fields[@]}"; do measure "${field%%=*}" "${field#*=}"; done
  write_table
}

main "$@"
