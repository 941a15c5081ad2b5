# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154
# The rows of docs/log/data/devices.json: figures from the examples' logs and programs. Sourced by tools/lab/devices.sh.

# value NAME FILE: the number after a word, the greatest of all lines.
value() {
  awk -v name="$1" '{ for (i = 1; i < NF; ++i) if ($i == name && $(i + 1) > most) most = $(i + 1) } END { print most + 0 }' "$2"
}

# bytes_of SIZE_PROGRAM ELF SECTION...
bytes_of() {
  local size=$1 elf=$2
  shift 2
  "$size" -A "$elf" | awk -v wanted=" $* " 'index(wanted, " " $1 " ") { sum += $2 } END { print sum + 0 }'
}

# Sections that take flash and RAM, by our linker scripts and the Pico SDK's.
flash_sections=(.boot .boot2 .vectors .hot .text .rodata .binary_info .ARM.exidx .data)
ram_sections=(.hot .data .bss .fast .ram_vector_table .scratch_x .scratch_y)

# Lines of a file of platform/ without comments.
lines_of() {
  grep --count --invert-match --extended-regexp '^[[:space:]]*((//|/\*| \* ).*)?$' "$root/platform/$1"
}

# write_row EXAMPLE MAIN SIZE_PROGRAM STACK RATE RATE_WITH_MISSES COUNTED: a row of the table, of the program of MAIN.cpp.
write_row() {
  local folder=${sources_of[$1]:-$1} name flash
  name=lumi_$folder
  [[ $2 == main ]] || name=lumi_${folder%%_*}_$2
  local elf=$devices/$1/build/$name.elf
  flash=$(($(bytes_of "$3" "$elf" "${flash_sections[@]}") - $(wc -c <"$field")))
  json_row source "$folder/$2.cpp" glue_lines "$(lines_of "$folder/$2.cpp")" flash_bytes "$flash" \
    ram_bytes "$(bytes_of "$3" "$elf" "${ram_sections[@]}")" stack "$4" fps "$5" fps_with_misses "$6" counted_by "$7" \
    same_bits yes >>"$devices/$1/row"
}

# rate HZ CLOCKS
rate() {
  awk -v hz="$1" -v clocks="$2" 'BEGIN { printf "%.1f", hz / clocks }'
}

# Writes the table and the pictures. Examples that need a path have no row: not every machine can make it anew.
write_docs() {
  local example
  for example in riscv lm3s_oled pico_st7789; do cat "$devices/$example/row"; done | put devices rows
  for example in lm3s_oled overlay pico_st7789; do
    cp "$devices/$example/frame-0.png" "$root/docs/img/device-$example.png"
  done
}
