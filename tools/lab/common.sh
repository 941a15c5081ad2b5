# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2034,SC2154
# The shell scripts of the laboratory source this, after `set -euo pipefail`. With LUMI or LUMI_LAB in the
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

# put NAME PART: rows from standard input become that part of docs/log/data/NAME.json, and the pages follow.
put() {
  python3 -B "$root/tools/lab/pages.py" put "$1" "$2"
}
