# SPDX-License-Identifier: MIT
# cmake -D SOURCE=dir -D BUILD=dir -D CPU=cpu -D ALL=ON|OFF -P build_board.cmake
# Configures and builds the project for a CPU, with one compiler at a time: ctest runs several of these side by side.
# Without debug information, which takes a third of the time and which no emulator reads.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G Ninja -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" -DCMAKE_TOOLCHAIN_FILE=${SOURCE}/toolchains/${CPU}.cmake
    -DLUMI_BUILD_TESTS=ON -DLUMI_BUILD_FIRMWARE=ON -DLUMI_TEST_ALL=${ALL}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --parallel 1 COMMAND_ERROR_IS_FATAL ANY)
