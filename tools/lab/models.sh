#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/models.sh FOLDER [EXTENSION...]
# Draws every model below FOLDER with `lumi reference`, and prints a table: drawn, with what was lost, or refused, and why.
# Pictures go to out/models. Extensions are gltf and glb unless others are named.
# For instance, with Debian's package assimp-testmodels: tools/lab/models.sh /usr/share/assimp/models
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

lumi=${LUMI:-$root/build/release/tools/lumi}
out=$root/out/models

# One row. What lumi says names the file first, which the row does already.
row() {
  local model=$1 name=${1#"$2"/} messages status=0 verdict
  messages=$(timeout 120 "$lumi" reference "$model" -o "$out/${name//\//_}.png" --orbit 30,20,3 --spp 16 --size 160x160 \
    2>&1 >/dev/null | grep -E '^lumi: ' | sed -E "s|^lumi: (warning: )?||; s|$model(:[0-9]+)?: ||; s/[|]/\\\\|/g") || status=$?
  [[ -f $out/${name//\//_}.png ]] && verdict=drawn || verdict=refused
  echo "| ${name} | $verdict | ${messages//$'\n'/<br>} |"
}

main() {
  (($# > 0)) || wrong_call "name a folder"
  [[ $1 != --help ]] || { help "$0" && exit; }
  local folder=${1%/} extensions=("${@:2}") names=() extension model
  ((${#extensions[@]} > 0)) || extensions=(gltf glb)
  for extension in "${extensions[@]}"; do names+=(-o -iname "*.$extension"); done
  rm -rf "$out" && mkdir -p "$out"
  echo "| model | | what lumi says |"
  echo "|---|---|---|"
  find "$folder" -type f \( "${names[@]:1}" \) | sort | while read -r model; do row "$model" "$folder"; done
}

main "$@"
