# SPDX-License-Identifier: MIT
# Frames that other compilers and machines draw from the same files: big-endian, of 32 bits, RISC-V, ARMv4T, and Clang;
# and RISC-V of 32 bits without an operating system, by its toolchain files.

# machine_test(NAME COMPILER [EMULATOR])
function(machine_test name compiler)
  foreach(program ${compiler} ${ARGN})
    lumi_find_program(${program} found)
    if(NOT found)
      message(FATAL_ERROR "The test machines.${name} needs ${program}: tools/install_packages.sh installs it.\n"
        "Or configure with -DLUMI_CROSS_TESTS=OFF to test on the host alone.")
    endif()
  endforeach()
  add_test(NAME machines.${name}
    COMMAND ${CMAKE_COMMAND} -D COMPILER=${compiler} -D "EMULATOR=${ARGN}" -D SOURCE=${PROJECT_SOURCE_DIR}
      -D GENERATED=${CMAKE_CURRENT_BINARY_DIR} -D PROGRAM=${CMAKE_CURRENT_BINARY_DIR}/frame_crcs_${name}
      -D HOST=$<TARGET_FILE:lumi_frame_crcs> -D "FIELDS=${lumi_test_fields}" -D EVERY_FRAME=${LUMI_TEST_ALL}
      -D "OPTIONS=${LUMI_${name}_OPTIONS}"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/machine_frames.cmake)
endfunction()

machine_test(s390x ${LUMI_MACHINE_PROGRAMS})
if(LUMI_TEST_ALL)
  machine_test(i686 i686-linux-gnu-g++ qemu-i386)
  machine_test(riscv64 riscv64-linux-gnu-g++ qemu-riscv64)
  machine_test(clang clang++)
  # toolchains/arm7tdmi.cmake; the emulator answers semihosting.
  set(LUMI_arm7tdmi_OPTIONS -mcpu=arm7tdmi -mthumb -mfloat-abi=soft -ffunction-sections -Wl,--gc-sections --specs=rdimon.specs)
  machine_test(arm7tdmi arm-none-eabi-g++ qemu-arm)
endif()

if(LUMI_TEST_ALL)
  foreach(cpu rv32imc rv32imafc)
    set(build ${PROJECT_BINARY_DIR}/cross/${cpu})
    add_test(NAME ${cpu}.build
      COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${build} -D CPU=${cpu} -D ALL=ON
        -P ${CMAKE_CURRENT_SOURCE_DIR}/riscv/build.cmake)
    set_tests_properties(${cpu}.build PROPERTIES FIXTURES_SETUP lumi_built_${cpu} COST 900 TIMEOUT ${lumi_build_timeout_s})
    add_test(NAME ${cpu}.frame_crcs
      COMMAND ${CMAKE_COMMAND} -D HOST=$<TARGET_FILE:lumi_frame_crcs> -D CPU=${cpu} -D FRAMES=${lumi_frames}
        -D BOARDS=${CMAKE_CURRENT_SOURCE_DIR}/riscv/boards.cmake -D PROGRAM=${build}/lumi_riscv_frame_crcs.elf
        -D "FIELDS=${lumi_test_fields}" -P ${CMAKE_CURRENT_SOURCE_DIR}/compare_frames.cmake)
    set_tests_properties(${cpu}.frame_crcs PROPERTIES FIXTURES_REQUIRED lumi_built_${cpu} TIMEOUT ${lumi_run_timeout_s})
  endforeach()
endif()
