#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/small_chip.sh
# The desk clock for a chip of 20 kB of RAM: plans and bakes it, and writes what docs/tradeoff.md prints (what the commands
# say, docs/log/data/small_chip.json) and its picture. The field lands in build/small_chip. With LUMI in the environment that
# program is taken as it is, and nothing is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

work=$root/build/small_chip

# told COMMAND...: the command as one types it, and what it says on standard output.
told() {
  echo "$ lumi $*"
  "$lumi" "$@"
}

commands() {
  told bake product.obj -o small.lumi --fit 60kB --ram 16kB --screen 240x240 --rows 4
  told inspect small.lumi --screen 240x240 --rows 8 --for rp2040,stm32f4 | sed -n '1p; / pixels of 16 bits/,$p'
}

# Lines as JSON rows.
as_rows() {
  python3 -c 'import json, sys
for line in sys.stdin:
    print(json.dumps({"line": line.rstrip("\n")}, ensure_ascii=False))'
}

main() {
  [[ ${1:-} != --help ]] || { help "$0" && exit; }
  (($# == 0)) || wrong_call "unknown option '$1'"
  [[ -n ${LUMI:-} ]] || run_step "Build" build_lumi
  mkdir -p "$work"
  cd "$work"
  cp "$root"/baker/scenes/product.obj "$root"/baker/scenes/product.mtl "$root"/baker/scenes/product_dial.png .
  commands >"$work/said"
  "$lumi" render small.lumi -o "$root/docs/img/small-chip.png" --mode antialiased --pixel rgb565 --orbit 30,20,3
  as_rows <"$work/said" | put small_chip said
}

main "$@"
