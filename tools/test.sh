#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/test.sh
# Builds everything with warnings as errors and runs all tests: on the host, on the host under AddressSanitizer and
# UndefinedBehaviorSanitizer, and cross-compiled on emulated Cortex-M boards. Installs missing packages when run as root.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# One ctest run over both trees, so that one summary counts every test.
join_trees() {
  printf 'subdirs(host host-sanitize)\n' >"$root/build/CTestTestfile.cmake"
}

main() {
  case ${1:-} in
    '') ;;
    --help) help "$0" && exit ;;
    *) wrong_call "unknown argument '$1'" ;;
  esac
  run_step "Packages" "$root/tools/install_packages.sh" tests
  run_step "Build for the host" build_preset host
  run_step "Build for the host, with sanitizers" build_preset host-sanitize
  join_trees
  print_step_times
  printf '\n== Tests (those of emulated boards build first)\n'
  ctest --test-dir "$root/build" --parallel "$jobs" --output-on-failure
}

main "$@"
