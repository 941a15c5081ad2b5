# SPDX-License-Identifier: MIT
# All RISC-V toolchain files share GNU tools found through PATH. They come without a C library; core needs none. The
# file that includes this one has set LUMI_RISCV_ARCH and LUMI_RISCV_ABI to names that -march and -mabi know.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES LUMI_RISCV_ARCH LUMI_RISCV_ABI)

foreach(lumi_program gcc g++)
  string(MAKE_C_IDENTIFIER "LUMI_RISCV_${lumi_program}" lumi_variable)
  find_program(${lumi_variable} riscv64-unknown-elf-${lumi_program})
  if(NOT ${lumi_variable})
    message(FATAL_ERROR "riscv64-unknown-elf-${lumi_program} was not found in PATH. On Debian:\n"
      "  apt-get install gcc-riscv64-unknown-elf")
  endif()
endforeach()
set(CMAKE_C_COMPILER ${LUMI_RISCV_gcc})
set(CMAKE_CXX_COMPILER ${LUMI_RISCV_g__})
set(CMAKE_ASM_COMPILER ${LUMI_RISCV_gcc})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(lumi_flags "-march=${LUMI_RISCV_ARCH} -misa-spec=2.2 -mabi=${LUMI_RISCV_ABI} -ffreestanding")
set(CMAKE_C_FLAGS_INIT "${lumi_flags}")
set(CMAKE_CXX_FLAGS_INIT "${lumi_flags}")
set(CMAKE_ASM_FLAGS_INIT "${lumi_flags}")
foreach(lumi_language C CXX ASM)
  set(CMAKE_EXECUTABLE_SUFFIX_${lumi_language} .elf)
endforeach()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
