#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/newcomer.sh [--sdk PATH] [FOLDER]
# Does what a newcomer does: runs the commands that the pages of the simulator and of the Pico print, in an empty folder
# that holds a copy of this repository as `lumi`, and prints how long each page took. Blocks of the pages that begin with
# "```sh" run; in the Pico's page "```sh sdk" in place of the one before it where --sdk names the Pico SDK.
# FOLDER: new or empty; without it, one in /tmp, which is removed.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

pages=(platform/README.md platform/simulator/README.md platform/pico_st7789/README.md)
sdk='' folder=''

parse_arguments() {
  while (($# > 0)); do
    case $1 in
      --sdk) sdk=$(realpath "${2:?--sdk takes a folder}") && shift ;;
      --help) help "$0" && exit ;;
      -*) wrong_call "unknown argument '$1'" ;;
      *) folder=$1 ;;
    esac
    shift
  done
}

# Copies what a clone of the repository would hold: everything but ignored files.
copy_repository() {
  mkdir "$folder/lumi"
  git -C "$root" ls-files -z --cached --others --exclude-standard |
    tar --create --directory "$root" --null --files-from - --ignore-failed-read 2>/dev/null |
    tar --extract --directory "$folder/lumi"
}

# commands PAGE: the commands of its blocks. A block "sh sdk" stands for the last one before it, or is left out.
commands() {
  awk -v with_sdk="$sdk" '
    /^```sh/ { inside = 1; block = ""; is_sdk = $2 == "sdk"; next }
    /^```/ && inside {
      inside = 0
      if (!is_sdk) blocks[++count] = block
      else if (with_sdk != "") blocks[count] = block
    }
    inside { block = block $0 "\n" }
    END { for (k = 1; k <= count; ++k) printf "%s", blocks[k] }' "$root/$1"
}

run_page() {
  local script
  script=$(commands "$1")
  [[ -n $script ]] || die "$1 prints no commands"
  (cd "$folder" && PICO_SDK_PATH=$sdk bash -euxo pipefail -c "$script")
}

main() {
  local page picture how
  parse_arguments "$@"
  if [[ -z $folder ]]; then
    folder=$(mktemp -d)
    # shellcheck disable=SC2064
    trap "report_failure \$?; rm -rf '$folder'" EXIT
  fi
  mkdir -p "$folder"
  folder=$(realpath "$folder")
  [[ -z $(ls -A "$folder") ]] || wrong_call "$folder is not empty"
  run_step "A copy of the repository" copy_repository
  for page in "${pages[@]}"; do run_step "$page" run_page "$page"; done
  for picture in frame-0.png panel.png; do
    [[ -s $folder/$picture ]] || die "the pages promise $picture, and it is not there"
  done
  print_step_times
  how=${sdk:+with the Pico SDK, $sdk}
  echo "The Pico's program was built ${how:-without an SDK}."
}

main "$@"
