#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/bench_baker.sh [--smoke] [speed] [adaptive]
# Measures the baker and prints rows of JSON; without a name, of both parts. speed: convergence, threads and memory; times
# are those of this machine, so leave it alone for the two minutes. adaptive: what adaptive sampling leaves out, which is the
# same on every machine of one kind. With --smoke it only tries every measurement on little work.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=(cornell.obj testcard.obj product.obj gallery.json)
convergence_rows=10  # rows of 64 texels
thread_rows=200
triangles=500000
adaptive_scenes=(cornell.obj product.obj gallery.json)
adaptive_texels=2000

# for_scenes COMMAND COUNT SCENE...
for_scenes() {
  local command=$1 count=$2 scene
  shift 2
  for scene; do
    "$lab" "$command" "$root/baker/scenes/$scene" "$count"
  done
}

print_convergence() {
  for_scenes convergence "$convergence_rows" "${scenes[@]}"
}

print_threads() {
  for_scenes threads "$thread_rows" "${scenes[@]}"
}

print_memory() {
  "$lab" memory "$triangles"
}

print_adaptive() {
  for_scenes adaptive "$adaptive_texels" "${adaptive_scenes[@]}"
}

parts=()
for word; do
  case $word in
    speed | adaptive) parts+=("$word") ;;
    --smoke)
      convergence_rows=1 thread_rows=2 triangles=2000 scenes=(cornell.obj)
      adaptive_scenes=(cornell.obj) adaptive_texels=20
      ;;
    --help) help "$0" && exit ;;
    *) wrong_call "unknown option '$word'" ;;
  esac
done
((${#parts[@]} > 0)) || parts=(speed adaptive)
read -ra parts <<<"${parts[*]/#speed/convergence threads memory}"
[[ -x $lab ]] ||
  die "$lab is missing: build it with 'cmake --preset release && cmake --build --preset release --target lumi-lab'"
for part in "${parts[@]}"; do "print_$part"; done
