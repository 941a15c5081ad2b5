#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/board_memory.sh [--check CPU...]
# RAM and stack of README's firmware, compiled as it is printed for every core: writes docs/log/data/devices.json, or with
# --check compares the rows of these cores with it. It takes the field that tools/lab/devices.sh bakes. Its bytes may differ a
# little from machine to machine, and so may how many vertices have a view table, for each of which gloss takes 2 bytes of RAM.
# So --check takes these 2 bytes for each from RAM; all else must be the same. Stack is the deepest chain of calls in
# GCC's call graph (tests/platform/check_stack.cmake), from the snippet's functions down; RAM its static data.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
lumi=${LUMI_TOOL:-$lumi}
cpus=(cortex-m0plus cortex-m3 cortex-m4 cortex-m7 cortex-m33 cortex-m55)
data=$root/docs/log/data/devices.json
check=
case ${1:-} in
--help) help "$0" && exit ;;
--check) check=yes && shift && cpus=("$@") ;;
esac
field=$root/build/devices/desk_clock.lumi
[ -f "$field" ] || "$root/tools/lab/devices.sh" --built --only field
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$lumi" embed "$field" -o "$work/product.S" >"$work/log"
cmake -D DOCUMENT="$root/README.md" -D LANGUAGE=cpp -D WITH=product_view -D OUT="$work/readme.cpp" \
    -P "$root/tests/platform/extract_snippet.cmake"
flags=(-std=c++17 -O2 -DNDEBUG -mthumb -mfloat-abi=soft -fno-exceptions -fno-rtti -ffunction-sections -fdata-sections)

# stack ROOTS: bytes of the deepest chain from functions of that name.
stack() {
    cmake -D FOLDERS="$work/$cpu" -D ROOTS="$1" -D LIMIT=100000 -P "$root/tests/platform/check_stack.cmake" 2>&1 |
        sed -n 's/.*chain takes \([0-9]*\) bytes.*/\1/p'
}

"$lumi" inspect "$field" | awk -v bytes="$(stat --format=%s "$field")" '
    $1 == "vertices" { vertices = $2 + 0 }
    match($0, /of which [0-9,]+ with a view table/) { split(substr($0, RSTART), word, " "); gsub(",", "", word[3]); viewed = word[3] }
    $1 == "mesh" { for (k = 2; k < NF; ++k) if ($(k + 1) ~ /^patches/) patches = $k }
    END { printf "{\"bytes\": %d, \"vertices\": %d, \"patches\": %d, \"viewed\": %d}\n", bytes, vertices, patches, viewed }' >"$work/field"
for cpu in "${cpus[@]}"; do
    mkdir "$work/$cpu"
    for source in $(sed -n 's/^  \(src[^)]*\).*/\1/p' "$root/core/sources.cmake") readme.cpp; do
        path=$root/core/$source
        [ "$source" = readme.cpp ] && path=$work/readme.cpp
        object=$work/$cpu/$(echo "$source" | tr / _).o
        case $source in
        *.S) arm-none-eabi-gcc -mcpu="$cpu" -mthumb -c "$path" -o "$object" ;;
        *) arm-none-eabi-g++ "${flags[@]}" -mcpu="$cpu" -fcallgraph-info=su -I "$root/core/include" -I "$root/core/src" \
            -I "$work" -c "$path" -o "$object" ;;
        esac
    done
    ram=$(arm-none-eabi-size "$work/$cpu/readme.cpp.o" | awk 'NR == 2 { print $2 + $3 }')
    # The flush is a call through a pointer, which a chain cannot follow: measured without it.
    sed -i '/__indirect_call/d' "$work/$cpu"/readme.cpp*.ci
    json_row cpu "$cpu" ram_bytes "$ram" open_stack_bytes "$(stack '^_Z5startv')" \
        draw_stack_bytes "$(stack '^_Z10draw_frame')" >>"$work/rows"
done
cat "$work/field" "$work/rows"
if [ -n "$check" ]; then
    python3 -B - "$data" "$work/field" "$work/rows" <<'EOF' || die "$data says otherwise; run tools/lab/board_memory.sh"
import json, sys
stated = json.load(open(sys.argv[1]))
told = {None: stated["field"][0], **{row["cpu"]: row for row in stated["memory"]}}
field = json.load(open(sys.argv[2]))
more_ram = 2 * (field["viewed"] - told[None]["viewed"])
def is_told(row):
    other = told[row.get("cpu")]
    ram = {"ram_bytes": row["ram_bytes"] - more_ram} if "ram_bytes" in row else {}
    return all((row | ram)[key] == other[key] or key in ("bytes", "viewed") or
               key == "ram_bytes" and abs(ram[key] - other[key]) < 8 for key in row)  # arrays end at multiples of 8
off = [row for path in sys.argv[2:] for row in map(json.loads, open(path)) if not is_told(row)]
sys.exit("\n".join(map(str, off)) or 0)
EOF
else
    put devices field <"$work/field"
    put devices memory <"$work/rows"
fi
