# SPDX-License-Identifier: MIT
# All ARM toolchain files share this: GNU Arm Embedded, found through PATH. The file that includes this one has set
# LUMI_ARM_CPU to a name that -mcpu knows.
#
# Soft-float ABI on every core, also on those that may have an FPU: lumi::core computes in integers only, so the FPU
# stays off, context switches stay short and one library fits chips with and without it.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES LUMI_ARM_CPU)

foreach(lumi_program gcc g++ nm size)
  string(MAKE_C_IDENTIFIER "LUMI_ARM_${lumi_program}" lumi_variable)
  find_program(${lumi_variable} arm-none-eabi-${lumi_program})
  if(NOT ${lumi_variable})
    message(FATAL_ERROR "arm-none-eabi-${lumi_program} was not found in PATH. On Debian:\n"
      "  apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib")
  endif()
endforeach()
set(CMAKE_C_COMPILER ${LUMI_ARM_gcc})
set(CMAKE_CXX_COMPILER ${LUMI_ARM_g__})
set(CMAKE_ASM_COMPILER ${LUMI_ARM_gcc})

# There is no start-up code to link with before a board is chosen: compiler checks stop at a library.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(lumi_flags "-mcpu=${LUMI_ARM_CPU} -mthumb -mfloat-abi=soft")
set(CMAKE_C_FLAGS_INIT "${lumi_flags}")
set(CMAKE_CXX_FLAGS_INIT "${lumi_flags}")
set(CMAKE_ASM_FLAGS_INIT "${lumi_flags}")
foreach(lumi_language C CXX ASM)
  set(CMAKE_EXECUTABLE_SUFFIX_${lumi_language} .elf)
endforeach()

# Programs run on the host; headers, libraries and packages of the host are never for this target.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
