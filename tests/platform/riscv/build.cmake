# SPDX-License-Identifier: MIT
# cmake -D SOURCE=dir -D BUILD=dir -D CPU=rv32imafc -D ALL=ON|OFF -P build.cmake
# Builds the frame list for a RISC-V CPU, with one compiler at a time.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/tests/platform/riscv -B ${BUILD} -G Ninja -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" -DCMAKE_TOOLCHAIN_FILE=${SOURCE}/toolchains/${CPU}.cmake
    -DLUMI_EVERY_FRAME=${ALL}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --parallel 1 COMMAND_ERROR_IS_FATAL ANY)
