#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/install_packages.sh build|tests|all [--print]
# Installs the Debian 12 packages that are missing: to build the `lumi` command, to run the tests too, or to run
# `tools/test.sh --all`.
# With --print it only lists them. This is the one list of what the project needs.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build_packages=(
  g++ cmake ninja-build pkg-config
  libembree-dev libtbb-dev         # ray queries
  libtinygltf-dev libdraco-dev     # glTF and GLB
  libtinyobjloader-dev             # OBJ and MTL
  libpng-dev libturbojpeg0-dev     # PNG and JPEG
  libstb-dev                       # writes PNG
  libwebp-dev                      # turning pictures, glTF's WebP
  libopenexr-dev                   # EXR
  libmeshoptimizer-dev             # meshes of few triangles
  libnifti2-dev zlib1g-dev         # volumes
  libkissfft-dev                   # CW-SSIM
  libcli11-dev nlohmann-json3-dev
  clang lld)                       # the pages of `lumi view`, in WebAssembly
test_packages=(
  catch2
  libopenvdb-dev                                                            # .vdb volumes and iso-surfaces, a module
  libboost-dev                                                              # headers, which those of OpenVDB include
  gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib  # code for Cortex-M
  qemu-system-arm                                                           # boards to run it on
  gcc-riscv64-unknown-elf qemu-system-misc                                  # the same for RISC-V
  g++-s390x-linux-gnu qemu-user                                             # a big-endian machine
  libsdl2-dev                                                               # the simulator's window
  arduino-builder                                                           # the Arduino library, as its IDE builds it
  slurm-wlm munge procps                                                    # a job array on this machine
  clang-tidy                                                                # checks what changed
  python3                                                                   # the generator of the scenes, includes
  python3-numpy)                                                            # the fit of what drawing costs
all_packages=(
  clang-format cppcheck gcovr g++-i686-linux-gnu g++-riscv64-linux-gnu dpkg-dev lintian groff-base
  libtorch-dev           # `lumi filter train`, `lumi render --filter`
  blender                # its export, beside Cycles
  chromium)              # the page of `lumi view`
# Each with the hash of its archive; they go to build/npm.
npm_packages=(  # for tests: an emulator of the RP2040
  rp2040js@1.4.1=sha512-Yzr5xG7ZwbtA50IYAU1k/oSoSyDAhPtT5qC/Q2eFApoLuAYE8DQbPIMPs/0kh4Ietd4P0OpKk3CIkfNqjcr56g==)
all_npm_packages=(  # moves Chromium
  puppeteer-core@24.43.1=sha512-T5ScUMAsmhdNbgDR41AGESYeS6V9MSgetkSnVhhW+gXvzC42VesKCn5ld87gAZDJ6vLHL9GkRvY9WtQWSnwFbw==)
command -v npm >/dev/null || test_packages+=(nodejs npm)  # whichever source they come from

is_installed() {
  [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

lock_timeout_s=600  # another process may be installing

# Fetches the lists of packages. apt-get waits for the lock of packages, but not for that of their lists.
update_lists() {
  local end=$((SECONDS + lock_timeout_s)) errors
  errors=$(mktemp)
  until LC_ALL=C apt-get update --quiet </dev/null 2>"$errors"; do
    cat "$errors" >&2
    if ((SECONDS >= end)) || ! grep --quiet 'get lock' "$errors"; then
      die "apt-get update failed; the messages above say why"
    fi
    sleep 5
  done
  rm "$errors"
}

install_missing() {
  local package missing=()
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then
    echo "All packages are installed."
    return
  fi
  echo "Missing packages: ${missing[*]}"
  if ((EUID != 0)); then
    die "run this as root, then start again:  apt-get update && apt-get install ${missing[*]}"
  fi
  export DEBIAN_FRONTEND=noninteractive
  update_lists
  apt-get -o DPkg::Lock::Timeout="$lock_timeout_s" install --yes --quiet --no-install-recommends "${missing[@]}" \
    </dev/null
}

# require_hash FOLDER NAME HASH: npm noted the hash of the archive that it unpacked.
require_hash() {
  grep --quiet --fixed-strings "\"integrity\": \"$3\"" "$1/package-lock.json" && return
  rm -rf "${1:?}/node_modules/$2"
  die "npm's archive of $2 is another one than expected; it was removed. Find out why before you change its hash here."
}

# Without them (no network) one test is skipped; `tools/test.sh --all` then fails.
install_npm_packages() {
  local entry package name folder=$root/build/npm
  for entry in "$@"; do
    package=${entry%%=*} name=${entry%%@*}
    [[ ! -d $folder/node_modules/$name ]] || continue
    if ! command -v npm >/dev/null; then
      echo "npm is missing: $package is not installed"
    elif ! npm install --prefix "$folder" --no-audit --no-fund "$package" </dev/null; then
      echo "npm could not install $package"
    else
      require_hash "$folder" "$name" "${entry#*=}"
    fi
  done
}

main() {
  local packages=()
  case ${1:-} in
    build) packages=("${build_packages[@]}") ;;
    tests) packages=("${build_packages[@]}" "${test_packages[@]}") ;;
    all) packages=("${build_packages[@]}" "${test_packages[@]}" "${all_packages[@]}") ;;
    --help) help "$0" && exit ;;
    *) wrong_call "say 'build', 'tests' or 'all'" ;;
  esac
  if [[ ${2:-} == --print ]]; then
    printf '%s\n' "${packages[@]}"
    return
  elif command -v dpkg-query >/dev/null; then
    install_missing "${packages[@]}"
  else
    echo "This is not Debian: install the counterparts of these yourself: ${packages[*]}"
  fi
  if [[ $1 != build ]]; then
    mkdir -p "$root/build/npm"
    if [[ $1 == all ]]; then npm_packages+=("${all_npm_packages[@]}"); fi
    install_npm_packages "${npm_packages[@]}"
  fi
}

main "$@"
