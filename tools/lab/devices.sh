#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/devices.sh [--docs] [--only EXAMPLE] [--lvgl PATH] [--pico-sdk PATH] [--tft-espi PATH]
#     [--lovyangfx PATH] [--built] [--may-skip]
# Builds the examples of platform/, runs each on its emulator and compares what the emulated display shows, bit by bit,
# with what `lumi render` or, in pixels that it does not write, the host's library draws. Ends with 0 only if all agree and
# nothing was left out but LVGL, the Pico SDK, TFT_eSPI and LovyanGFX, of which it says so.
#   --docs          writes the table and the pictures of platform/README.md
#   --only EXAMPLE  one of them: field (bakes what they draw), riscv, lm3s_oled, pico_st7789, simulator, overlay, lvgl,
#                   clock, pico_sdk, pico_measure, tft_espi, lovyangfx, table (of what was run last)
#   --lvgl PATH     a source tree of LVGL 9, which nothing fetches; without it platform/lvgl is left out
#   --pico-sdk PATH the Pico SDK: platform/pico_st7789 is built against it, too, and run, and so is platform/measure/pico
#   --tft-espi PATH, --lovyangfx PATH  these libraries for Arduino: their headers take the calls of our sketches
#   --built         `lumi` and the tests' programs are built already, in build/release
#   --may-skip      ends with 77 where an emulator is missing
# Results, and a PNG of every display, lie in build/devices.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
# shellcheck source-path=SCRIPTDIR source=devices/table.sh
source "$root/tools/lab/devices/table.sh"

devices=$root/build/devices
lumi=$root/build/release/tools/lumi
field=$devices/desk_clock.lumi
clock=$devices/running_clock.lumi
declare -A sources_of=([pico_sdk]=pico_st7789 [pico_measure]=measure/pico)  # where the folder has another name
examples=(riscv lm3s_oled pico_st7789 simulator overlay clock)
lvgl='' pico_sdk='' tft_espi='' lovyangfx='' only='' built='' may_skip='' docs=''
frames=2
npm_folder=$root/build/npm

parse_arguments() {
  while (($# > 0)); do
    case $1 in
      --docs) docs=yes ;;
      --only) only=${2:?--only takes the name of an example} && shift ;;
      --lvgl) lvgl=${2:?--lvgl takes a folder} && shift ;;
      --pico-sdk) pico_sdk=$(realpath "${2:?--pico-sdk takes a folder}") && shift ;;
      --tft-espi) tft_espi=$(realpath "${2:?--tft-espi takes a folder}") && shift ;;
      --lovyangfx) lovyangfx=$(realpath "${2:?--lovyangfx takes a folder}") && shift ;;
      --built) built=yes ;;
      --may-skip) may_skip=yes ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown argument '$1'" ;;
    esac
    shift
  done
  if [[ -n $only && " field table lvgl pico_sdk pico_measure tft_espi lovyangfx ${examples[*]} " != *" $only "* ]]; then
    wrong_call "no example is called '$only'"
  fi
}

# require EXAMPLE PROGRAM...: ends the script where a program is missing.
require() {
  local example=$1 program
  shift
  for program in "$@"; do
    command -v "$program" >/dev/null && continue
    echo "SKIPPED $example: $program is missing; tools/install_packages.sh tests installs it" >&2
    [[ -z $may_skip ]] || exit 77
    exit 1
  done
}

# bake_field [PATHS]: the desk clock of some 80 kB that every example draws. Its size differs by a few bytes between
# processors: 80,936 and 80,944 were seen.
bake_field() {
  mkdir -p "$devices"
  "$lumi" bake "$root/baker/scenes/product.obj" -o "$field" --triangles 1200 --longest-edge 0.5 --texel-density 44 \
    --paths "${1:-20}" --restart
}

# Bakes that clock with hands that move, coarsely: tests compare pictures.
bake_clock() {
  "$lumi" bake "$root/baker/scenes/clock.json" -o "$clock" --triangles 700 --longest-edge 0.5 --texel-density 20 --paths 2 \
    --restart
}

# build EXAMPLE TOOLCHAIN [OPTION...]: a project of its own, as a user would have it.
build() {
  local folder=$devices/$1/build options=(-DLUMI_TOOL="$lumi" -DLUMI_EXAMPLE_FIELD="$field" "${@:3}")
  [[ $2 == host ]] || options+=(--toolchain "$root/toolchains/$2.cmake")
  cmake -S "$root/platform/${sources_of[$1]:-$1}" -B "$folder" -G Ninja "${options[@]}" >"$devices/$1/configure.log" ||
    die "platform/$1 cannot be configured: $devices/$1/configure.log"
  cmake --build "$folder" --parallel 1
}

# check EXAMPLE FORMAT SIZE FRAME [EXPECTED EXPECTED_FORMAT]: a display's picture as PNG, and that it is the expected one,
# by default what `lumi render` draws.
check() {
  local folder=$devices/$1 format=$2 size=$3 frame=$4 expected=${5:-} expected_format=${6:-png}
  local pixels=$folder/frame-$frame.raw output=()
  if [[ -z $expected ]]; then
    expected=$folder/expected-$frame.png
    "$lumi" render "$field" -o "$expected" --size "$size" --orbit $((30 + 300 * frame)),$((20 + 15 * frame)),3 \
      --mode antialiased --pixel rgb565 --background black >/dev/null
  fi
  if [[ $format == png ]]; then pixels=$folder/frame-$frame.png; else output=(-o "$folder/frame-$frame.png"); fi
  python3 -B "$root/tools/lab/devices/picture.py" "$format" "$size" "$pixels" "${output[@]}" --same-as "$expected" \
    "$expected_format"
}

# Clocks an instruction that are assumed where an emulator counts instructions alone, in tenths.
tenths_an_instruction=13

# emulate_riscv FOLDER PROGRAM: the frames go to the folder.
emulate_riscv() {
  (
    cd "$1" || exit
    qemu-system-riscv32 -M virt -cpu lowrisc-ibex -m 64M -bios none -display none -serial none -monitor none \
      -chardev stdio,id=console -semihosting-config enable=on,target=native,chardev=console -icount shift=0 -kernel "$2"
  )
}

run_riscv() {
  require riscv riscv64-unknown-elf-g++ qemu-system-riscv32
  build riscv rv32imc
  local folder=$devices/riscv frame
  emulate_riscv "$folder" "$folder/build/lumi_riscv.elf" | tee "$folder/log"
  for ((frame = 0; frame < frames; ++frame)); do check riscv rgb565-swapped 240x240 "$frame"; done
  local clocks=$(($(value instructions "$folder/log") * tenths_an_instruction / 10))
  write_row riscv main riscv64-unknown-elf-size "$(value stack "$folder/log")" "$(rate 160000000 "$clocks")" – "instructions × 1.3, 160 MHz"
}

run_lm3s_oled() {
  require lm3s_oled arm-none-eabi-g++ qemu-system-arm python3
  build lm3s_oled cortex-m3
  local folder=$devices/lm3s_oled frame
  python3 -B "$root/tools/lab/devices/run_oled.py" "$folder/build/lumi_lm3s_oled.elf" "$folder" | tee "$folder/log"
  for ((frame = 0; frame < frames; ++frame)); do
    draw_expected lm3s_oled grey4 128 64 16 "$frame" "$(turns $((30 + 300 * frame)))" "$(turns $((20 + 15 * frame)))"
    check lm3s_oled grey4 128x64 "$frame" "$folder/expected-$frame.raw" grey4
  done
  local clocks=$(($(value instructions "$folder/log") * tenths_an_instruction / 10))
  write_row lm3s_oled main arm-none-eabi-size "$(value stack "$folder/log")" "$(rate 50000000 "$clocks")" – "instructions × 1.3, 50 MHz"
}

# Degrees in 2^-32 turns.
turns() {
  awk -v degrees="$1" 'BEGIN { printf "%.0f", degrees * 4294967296 / 360 }'
}

# draw_expected EXAMPLE FORMAT WIDTH HEIGHT STRIPE_ROWS FRAME AZIMUTH ELEVATION [ZOOM]
draw_expected() {
  "$root/build/release/tests/platform/lumi_device_picture" "$field" "$2" "$3" "$4" "$5" "$7" "$8" \
    "$devices/$1/expected-$6.raw" ${9+"$9"}
}

# run_pico EXAMPLE NAME COUNTED: a program of one or two cores, with and without modelled flash misses, and its row.
run_pico() {
  local folder=$devices/$1 frame option stack
  for option in --flash-misses ''; do
    # shellcheck disable=SC2086
    NODE_PATH=$npm_folder/node_modules node "$root/tools/lab/devices/pico/run.cjs" "$folder/build/lumi_pico_$2.bin" "$folder" \
      $option | tee "$folder/log-$2$option"
    for ((frame = 0; frame < frames; ++frame)); do check "$1" rgb565-swapped 240x240 "$frame"; done
    rm "$folder"/*.raw
  done
  stack=$(value stack "$folder/log-$2")
  [[ $2 == st7789 ]] || stack="$stack + $(value core1-stack "$folder/log-$2")"
  write_row "$1" "$3" arm-none-eabi-size "$stack" "$(rate 1000000 "$(value microseconds "$folder/log-$2")")" \
    "$(rate 1000000 "$(value microseconds "$folder/log-$2--flash-misses")")" "$4"
}

require_rp2040js() {
  require "$1" arm-none-eabi-g++ node python3
  [[ -d $npm_folder/node_modules/rp2040js ]] || require "$1" "rp2040js (of npm)"
}

run_pico_st7789() {
  require_rp2040js pico_st7789
  build pico_st7789 cortex-m0plus -DPICO_SDK_PATH=
  run_pico pico_st7789 st7789 main "rp2040js's clocks, 125 MHz"
  run_pico pico_st7789 two_cores two_cores "the same; core 1 modelled"
}

# Runs these programs behind the SDK's start-up, with the SDK's drivers and its launch of core 1.
run_pico_sdk() {
  [[ -n $pico_sdk ]] || die "name the Pico SDK: --pico-sdk PATH"
  require_rp2040js pico_sdk
  build pico_sdk host -DPICO_SDK_PATH="$pico_sdk"
  run_pico pico_sdk st7789 main "the same; Pico SDK $(pico_sdk_version)"
  run_pico pico_sdk two_cores two_cores "the same; Pico SDK $(pico_sdk_version), core 1 modelled"
}

# The program that measures a real board; here it prints what the emulator takes.
run_pico_measure() {
  [[ -n $pico_sdk ]] || die "name the Pico SDK: --pico-sdk PATH"
  require_rp2040js pico_measure
  local folder=$devices/pico_measure
  build pico_measure host -DPICO_SDK_PATH="$pico_sdk" -DPICO_NO_PICOTOOL=ON -DFIELD="$field"
  NODE_PATH=$npm_folder/node_modules node "$root/tools/lab/devices/pico/run.cjs" "$folder/build/lumi_measure.bin" "$folder" \
    --flash-misses --json 2
}

pico_sdk_version() {
  sed --quiet 's/^ *set(PICO_SDK_VERSION_\(MAJOR\|MINOR\|REVISION\) \([0-9]*\))/\2/p' "$pico_sdk/pico_sdk_version.cmake" |
    paste --serial --delimiters=.
}

# require_simulator EXAMPLE
require_simulator() {
  require "$1" c++ pkg-config
  pkg-config --exists sdl2 || require "$1" sdl2
}

# A round panel differs in the pixels outside of its disc, which are black without the mask, and in no others.
check_round_mask() {
  local outside
  mkdir -p "$1/round"
  "$1/build/lumi_simulator" --frames "$1/round" --mask round
  outside=$(awk 'BEGIN { for (x = -239; x < 240; x += 2) for (y = -239; y < 240; y += 2) n += x * x + y * y > 240 * 240; print n }')
  [[ $(python3 -B "$root/tools/lab/devices/picture.py" png 240x240 "$1/frame-0.png" --same-as "$1/round/frame-0.png" png 2>&1) == \
    *": $outside pixels differ"* ]] || die "simulator: --mask round does not show a disc"
}

run_simulator() {
  require_simulator simulator
  build simulator host
  local folder=$devices/simulator frame
  mkdir -p "$folder/dragged"
  "$folder/build/lumi_simulator" --frames "$folder"
  for ((frame = 0; frame < frames; ++frame)); do check simulator png 240x240 "$frame"; done
  SDL_VIDEODRIVER=dummy "$folder/build/lumi_simulator" --frames "$folder/dragged" --drag 20,-10 --rate 20
  "$lumi" render "$field" -o "$folder/expected-dragged.png" --orbit 10,10,3 --mode antialiased --pixel rgb565 --background black >/dev/null
  python3 -B "$root/tools/lab/devices/picture.py" png 240x240 "$folder/dragged/frame-1.png" \
    --same-as "$folder/expected-dragged.png" png
  check_round_mask "$folder"
  mkdir -p "$folder/threads"
  "$folder/build/lumi_simulator_two_cores" --frames "$folder/threads"
  for ((frame = 0; frame < frames; ++frame)); do
    python3 -B "$root/tools/lab/devices/picture.py" png 240x240 "$folder/threads/frame-$frame.png" \
      --same-as "$folder/frame-$frame.png" png
  done
}

# Draws over a baked face, on an emulated device and on the host.
run_overlay() {
  require overlay riscv64-unknown-elf-g++ qemu-system-riscv32
  require_simulator overlay
  mkdir -p "$devices"/{riscv,simulator} "$devices/overlay/host"
  build riscv rv32imc
  build simulator host
  local folder=$devices/overlay frame
  emulate_riscv "$folder" "$devices/riscv/build/lumi_riscv_overlay.elf"
  "$devices/simulator/build/lumi_simulator_overlay" --frames "$folder/host"
  for ((frame = 0; frame < frames; ++frame)); do
    check overlay rgb565-swapped 240x240 "$frame" "$folder/host/frame-$frame.png" png
  done
}

# A clock's first seconds, each on what the second before left on the display: on an emulated Pico and on the host.
run_clock() {
  require_rp2040js clock
  require_simulator clock
  mkdir -p "$devices/clock/host" "$devices/pico_st7789" "$devices/simulator"
  bake_clock
  build pico_st7789 cortex-m0plus -DPICO_SDK_PATH= -DLUMI_CLOCK_FIELD="$clock"
  build simulator host -DLUMI_CLOCK_FIELD="$clock"
  local folder=$devices/clock frame second
  NODE_PATH=$npm_folder/node_modules node "$root/tools/lab/devices/pico/run.cjs" \
    "$devices/pico_st7789/build/lumi_pico_clock.bin" "$folder" --frames 4 | tee "$folder/log"
  "$devices/simulator/build/lumi_simulator_clock" --frames "$folder/host"
  for ((frame = 0; frame < 4; ++frame)); do
    second=$((36537 + frame))  # board.h's kFirstSecond
    "$lumi" render "$clock" -o "$folder/expected-$frame.png" --size 240x240 --orbit 30,20,3 --mode antialiased \
      --pixel rgb565 --background black --part second_hand=$((second % 60 * 6)) \
      --part minute_hand=$((second / 10 % 360)) --part "hour_hand=$(awk "BEGIN { print int($second / 60) / 2 }")" >/dev/null
    check clock rgb565-swapped 240x240 "$frame" "$folder/expected-$frame.png"
  done
  for ((frame = 0; frame < frames; ++frame)); do
    check clock png 240x240 "$frame" "$folder/host/frame-$frame.png"
  done
}

# Under labels and a slider: LVGL blends outlines itself, all else has our bits.
run_lvgl() {
  [[ -n $lvgl ]] || die "name a source tree of LVGL 9: --lvgl PATH"
  local folder=$devices/lvgl frame side rows azimuth elevation zoom format
  bake_clock
  build lvgl host -DLVGL_DIR="$lvgl" -DLUMI_CLOCK_FIELD="$clock"
  "$folder/build/lumi_lvgl_clock"
  "$folder/build/lumi_lvgl" "$folder" | tee "$folder/log"
  while read -r _ frame _ _ _ _ side _ rows _ azimuth _ elevation _ zoom _; do
    for format in rgb565 coverage; do
      draw_expected lvgl "$format" "$side" "$side" "$rows" "$frame" "$azimuth" "$elevation" "$zoom"
      mv "$folder/expected-$frame.raw" "$folder/$format-$frame.expected"
    done
    python3 -B "$root/tools/lab/devices/compare_lvgl.py" "$folder/log" "$frame" "$folder/frame-$frame.raw" \
      "$folder/rgb565-$frame.expected" "$folder/coverage-$frame.expected"
    python3 -B "$root/tools/lab/devices/picture.py" rgb565 320x240 "$folder/frame-$frame.raw" -o "$folder/frame-$frame.png"
  done < <(grep '^frame' "$folder/log")
  # The first view has whole degrees: `lumi render` draws it.
  side=$(value side "$folder/log")
  "$lumi" render "$field" -o "$folder/rendered.png" --size "${side}x$side" --orbit 30,20,3 --mode antialiased \
    --pixel rgb565 --background black >/dev/null
  python3 -B "$root/tools/lab/devices/picture.py" rgb565 "${side}x$side" "$folder/rgb565-0.expected" \
    --same-as "$folder/rendered.png" png
}

# check_sketch EXAMPLE SKETCH HEADERS LINE...: a library's own headers take the sketch's calls; the lines come before it.
# Arduino's core is names alone.
check_sketch() {
  local folder=$devices/$1 arduino=$root/tests/platform/arduino sketch=$root/platform/arduino/examples/$2/$2.ino
  require "$1" arm-none-eabi-g++
  mkdir -p "$folder/lumi_fields"
  "$lumi" embed "$field" -o "$folder/lumi_fields/desk_clock.c" >/dev/null
  printf '%s\n' '#include <Print.h>' '#include <SPI.h>' "${@:4}" "#include \"$sketch\"" >"$folder/sketch.cpp"
  arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb -std=gnu++17 -fsyntax-only -w -DARDUINO=10819 \
    -I"$arduino"/hardware/lumi/rp2040/cores/emulated -I"$arduino/real_headers" -I"$root/platform/arduino/src" \
    -I"$root/core/include" -I"$folder" -isystem "$3" "$folder/sketch.cpp"
}

run_tft_espi() {
  [[ -n $tft_espi ]] || die "name the library TFT_eSPI: --tft-espi PATH"
  check_sketch tft_espi DeskClockTFT_eSPI "$tft_espi"
}

# Its autodetection knows no emulated board: a device without a panel stands in.
run_lovyangfx() {
  [[ -n $lovyangfx ]] || die "name the library LovyanGFX: --lovyangfx PATH"
  check_sketch lovyangfx DeskClockLovyanGFX "$lovyangfx/src" '#include <LovyanGFX.hpp>' \
    'class LGFX : public lgfx::LGFX_Device {};'
}

run_example() {
  mkdir -p "$devices/$1"
  rm -f "$devices/$1"/{log*,row,*.raw,*.png}
  "run_$1"
  echo "$1: agrees"
}

publish() {
  [[ -z $docs ]] || write_docs
  [[ -n $pico_sdk ]] || echo "pico_sdk was not run: it needs the SDK: --pico-sdk PATH"
  [[ -n $lvgl ]] || echo "SKIPPED lvgl: it needs LVGL's source: --lvgl PATH"
  [[ -n $tft_espi ]] || echo "SKIPPED tft_espi: it needs the library TFT_eSPI: --tft-espi PATH"
  [[ -n $lovyangfx ]] || echo "SKIPPED lovyangfx: it needs the library LovyanGFX: --lovyangfx PATH"
}

main() {
  parse_arguments "$@"
  if [[ -z $built ]]; then
    run_step "Packages" "$root/tools/install_packages.sh" tests
    (
      cd "$root" || exit
      cmake --preset host
      cmake --build --preset host --parallel "$jobs" --target lumi lumi_device_picture
    )
  fi
  case $only in
    '')
      bake_field
      [[ -z $lvgl ]] || examples+=(lvgl)
      [[ -z $pico_sdk ]] || examples+=(pico_sdk pico_measure)
      [[ -z $tft_espi ]] || examples+=(tft_espi)
      [[ -z $lovyangfx ]] || examples+=(lovyangfx)
      for example in "${examples[@]}"; do run_step "$example" run_example "$example"; done
      publish
      ;;
    field) bake_field 4 ;;  # tests compare pictures of one field
    table) publish ;;
    *) run_example "$only" ;;
  esac
}

main "$@"
