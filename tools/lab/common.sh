# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2034,SC2154
# What the shell scripts of the laboratory share; sourced, after `set -euo pipefail`. With LUMI or LUMI_LAB in the
# environment those programs are taken as they are.
# shellcheck source-path=SCRIPTDIR source=../common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

lumi=${LUMI:-$root/build/release/tools/lumi}
lab=${LUMI_LAB:-$root/build/release/tools/lab/lumi-lab}

build_lab() {
  cmake --build "$root/build/release" --parallel "$jobs" --target lumi-lab
}

# json_row KEY VALUE...: a line of JSON; numbers and JSON stay what they are, other values are text.
json_row() {
  python3 -c 'import json, sys
def value(text):
    try:
        return json.loads(text)
    except ValueError:
        return text
words = sys.argv[1:]
print(json.dumps({key: value(text) for key, text in zip(words[::2], words[1::2])}, ensure_ascii=False))' "$@"
}

# mean_figures COUNT: the means of what `lumi compare` said of so many pictures, from standard input, as JSON.
mean_figures() {
  awk -v count="$1" '{ sum[$1] += $2 }
    END { printf "{\"psnr_db\": %.4f, \"ssim\": %.5f, \"flip\": %.5f}", sum["PSNR"] / count, sum["SSIM"] / count, sum["FLIP"] / count }'
}

# put NAME PART: rows from standard input become that part of docs/log/data/NAME.json, and the pages follow.
put() {
  python3 -B "$root/tools/lab/pages.py" put "$1" "$2"
}

# write_scenes WRITER ARGUMENT...: what the scripts that bake scenes of tools/lab/scenes begin with. Takes --scene NAME
# (may be repeated) into the array `scenes`, --paths into `paths`, --fit into `fit` where the script has one, and --help;
# builds lumi; runs the WRITER of that folder, whose scenes go to $work/scenes.
write_scenes() {
  local writer=$1 chosen=()
  shift
  while (($#)); do
    case $1 in
      --scene) chosen+=("${2:?"--scene needs a name"}") && shift ;;
      --paths) paths=${2:?"--paths needs a number"} && shift ;;
      --fit) [[ -v fit ]] || wrong_call "unknown option '$1'" && fit=${2:?"--fit needs a size"} && shift ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  if ((${#chosen[@]})); then scenes=("${chosen[@]}"); fi
  mkdir -p "$work"
  if [[ -z ${LUMI:-} ]]; then run_step "Build" build_lumi; fi
  run_step "Write the scenes" python3 "$root/tools/lab/scenes/$writer" "$work/scenes"
}
