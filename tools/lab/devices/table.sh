# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154
# The table of docs/boards.md: figures from the examples' logs and programs. Sourced by tools/lab/devices.sh.

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

thousands() {
  awk -v n="$1" 'BEGIN { printf "%.1f kB", n / 1000 }'
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
  # shellcheck disable=SC2016
  printf '| `%s/%s.cpp` | %s | %s | %s | %s B | %s | %s | %s | yes |\n' "$folder" "$2" "$(lines_of "$folder/$2.cpp")" \
    "$(thousands "$flash")" "$(thousands "$(bytes_of "$3" "$elf" "${ram_sections[@]}")")" "$4" "$5" "$6" "$7" \
    >>"$devices/$1/row"
}

# rate HZ CLOCKS
rate() {
  awk -v hz="$1" -v clocks="$2" 'BEGIN { printf "%.1f", hz / clocks }'
}

print_table() {
  local example
  # shellcheck disable=SC2016
  echo '| `platform/` | glue lines | flash | RAM | stack | frames a second | with flash misses | counted by | same bits |'
  echo '|---|---:|---:|---:|---:|---:|---:|---|---|'
  for example in riscv lm3s_oled gba pico_st7789 pico_sdk lvgl; do
    [[ ! -f $devices/$example/row ]] || cat "$devices/$example/row"
  done
  # shellcheck disable=SC2016
  [[ -f $devices/lvgl/row ]] || echo '| `lvgl/main.c` | SKIPPED: no `--lvgl PATH` | – | – | – | – | – | – | – |'
}

write_docs() {
  replace_between "$root/docs/boards.md" '<!-- devices table: begin (tools/lab/devices.sh --docs) -->' \
    '<!-- devices table: end -->' "$devices/table"
  for example in gba lm3s_oled overlay pico_st7789 lvgl; do
    [[ ! -f $devices/$example/frame-0.png ]] || cp "$devices/$example/frame-0.png" "$root/docs/img/device-$example.png"
  done
}
