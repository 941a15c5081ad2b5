# SPDX-License-Identifier: MIT
# Builds the project for every CPU, once per ctest run and only if a test of that CPU runs, and tests what was built.
foreach(program IN LISTS LUMI_CROSS_PROGRAMS)
  lumi_find_program(${program} lumi_found)
  if(NOT lumi_found)
    message(FATAL_ERROR "The cross tests need ${program}. On Debian:\n"
      "  apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm\n"
      "Or configure with -DLUMI_CROSS_TESTS=OFF to test on the host alone.")
  endif()
endforeach()

set(lumi_boards ${PROJECT_SOURCE_DIR}/platform/mps2/boards.cmake)
include(${lumi_boards})

# Deepest stack of render(), of render_spans(), and of prepare_surface() and render_surface(), on any of the CPUs, as
# docs/firmware.md states it.
set(LUMI_STACK_LIMIT 1024)
set(LUMI_SPAN_STACK_LIMIT 2624)
set(LUMI_SURFACE_STACK_LIMIT 3072)
# No program that draws chord fields alone holds these.
set(lumi_surface_symbols ".*([Ss]urface|view_taps|view_frame).*")
set(lumi_see_through_symbols ".*([Ss]ee_?[Tt]hrough|blend_(565|packed)).*")
# No program whose fields rest holds these.
set(lumi_part_symbols ".*(MovingPieces|begin_moving|put_parts|read_parts|rest_parts|part_motion|turn_part|slide_part|changed_rects|of_body).*")
# No program that weighs no lights holds these.
set(lumi_state_symbols ".*(put_states|read_states|set_state|state_name|light_by_states).*")
# No program whose fields have no gloss maps holds these.
set(lumi_gloss_symbols ".*(GlossPieces|put_gloss|read_gloss|gloss_rows|glossy).*")
# No program whose fields have no view tables holds these.
set(lumi_view_table_symbols ".*(lit_colour|view_taps|view_frame).*")
# No program in C that opens, looks and draws surface fields over black holds these: other calls of lumi.h, what they
# call in turn, and what draws chord fields.
set(lumi_other_calls "lumi_(drag|pack|quality|held|moved|pose|fov|turn|slide|set_state|changed|draw_over|draw_coverage|verify|error).*"
  ".*(OrbitDrag|QualityLadder|pack_rows|held_pose|OverColour|OverStripe|OverNothing|render_coverage).*")
set(lumi_chord_symbols ".*(render_spans|ChordStepper|open_field|make_camera).*")
set(lumi_build_timeout_s 1500)
set(lumi_run_timeout_s 1800)  # every unit test of core takes 15 minutes where the host has other work

set(lumi_cpus ${LUMI_MPS2_CPUS})
if(NOT LUMI_TEST_ALL)
  list(REMOVE_ITEM lumi_cpus ${LUMI_BOARDS_OF_ALL})
endif()
foreach(cpu IN LISTS lumi_cpus)
  set(lumi_cross ${PROJECT_BINARY_DIR}/cross/${cpu})
  set(lumi_firmware ${lumi_cross}/platform/mps2)

  add_test(NAME ${cpu}.build
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${lumi_cross} -D CPU=${cpu} -D ALL=${LUMI_TEST_ALL}
      -P ${CMAKE_CURRENT_SOURCE_DIR}/build_board.cmake)
  # Boards build side by side, each with one compiler, and before all else.
  set_tests_properties(${cpu}.build PROPERTIES FIXTURES_SETUP lumi_built_${cpu} COST 1000
    TIMEOUT ${lumi_build_timeout_s})

  set(lumi_cpu_tests)
  # Catch2 3 is built for the host alone.
  if(Catch2_VERSION VERSION_LESS 3 AND (LUMI_TEST_ALL OR cpu IN_LIST LUMI_UNIT_TEST_CPUS))
    add_test(NAME ${cpu}.core_tests
      COMMAND ${CMAKE_COMMAND} -D CPU=${cpu} -D PROGRAM=${lumi_cross}/tests/cross/lumi_core_tests.elf
        -P ${PROJECT_SOURCE_DIR}/platform/mps2/run.cmake)
    set_tests_properties(${cpu}.core_tests PROPERTIES COST 900)  # the longest of all, in one thread
    list(APPEND lumi_cpu_tests ${cpu}.core_tests)
  endif()
  if(cpu IN_LIST LUMI_UNIT_TEST_CPUS)
    set(chord ${CMAKE_CURRENT_BINARY_DIR}/fields/rgb565.lumi)
    set(surface ${CMAKE_CURRENT_BINARY_DIR}/fields/surface.lumi)
    foreach(pair "surface;chord" "chord;surface")
      list(GET pair 0 kind)
      list(GET pair 1 other)
      add_test(NAME ${cpu}.bad_input_${kind}
        COMMAND ${CMAKE_COMMAND} -D CPU=${cpu} -D PROGRAM=${lumi_cross}/tests/cross/lumi_bad_${kind}.elf
          -D "FIELDS=${${kind}};${${other}}" -P ${PROJECT_SOURCE_DIR}/platform/mps2/run.cmake)
      list(APPEND lumi_cpu_tests ${cpu}.bad_input_${kind})
    endforeach()
    # A read behind the guarded memory faults.
    add_test(NAME ${cpu}.wild_read_faults
      COMMAND ${CMAKE_COMMAND} -D CPU=${cpu} -D ARGUMENTS=wild -D PROGRAM=${lumi_cross}/tests/cross/lumi_bad_chord.elf
        -P ${PROJECT_SOURCE_DIR}/platform/mps2/run.cmake)
    set_tests_properties(${cpu}.wild_read_faults PROPERTIES PASS_REGULAR_EXPRESSION "fault: .*ended with 70")
    add_test(NAME ${cpu}.chord_firmware_links_no_surface
      COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D FILES=${lumi_cross}/tests/cross/lumi_bad_chord.elf
        -D "FORBIDDEN=${lumi_surface_symbols}" -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
    list(APPEND lumi_cpu_tests ${cpu}.wild_read_faults ${cpu}.chord_firmware_links_no_surface)
  endif()
  add_test(NAME ${cpu}.board
    COMMAND ${CMAKE_COMMAND} -D CPU=${cpu} -D PROGRAM=${lumi_cross}/tests/cross/lumi_board_test.elf
      -D COUNT_INSTRUCTIONS=ON -P ${PROJECT_SOURCE_DIR}/platform/mps2/run.cmake)
  add_test(NAME ${cpu}.refuses_missing_fields
    COMMAND ${CMAKE_COMMAND} -D CPU=${cpu} -D PROGRAM=${lumi_firmware}/lumi_frame_crcs_firmware.elf
      -P ${PROJECT_SOURCE_DIR}/platform/mps2/run.cmake)
  set_tests_properties(${cpu}.refuses_missing_fields PROPERTIES
    PASS_REGULAR_EXPRESSION "^error: .*\n.*ended with 1")
  add_test(NAME ${cpu}.frame_crcs
    COMMAND ${CMAKE_COMMAND} -D HOST=$<TARGET_FILE:lumi_frame_crcs> -D BOARDS=${lumi_boards} -D CPU=${cpu}
      -D PROGRAM=${lumi_firmware}/lumi_frame_crcs_firmware.elf -D "FIELDS=${lumi_test_fields}" -D FRAMES=${lumi_frames}
      -P ${CMAKE_CURRENT_SOURCE_DIR}/compare_frames.cmake)
  list(APPEND lumi_cpu_tests ${cpu}.board ${cpu}.refuses_missing_fields ${cpu}.frame_crcs)

  # Core's proof.
  set(lumi_policies ${lumi_cross}/tests/cross/CMakeFiles/lumi_policies.dir)
  add_test(NAME ${cpu}.core_symbols
    COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm}
      -D "FILES=${lumi_cross}/core/liblumi_core.a;${lumi_cross}/tests/cross/liblumi_policies.a;${lumi_firmware}/lumi_frame_crcs_firmware.elf"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
  add_test(NAME ${cpu}.core_stack
    COMMAND ${CMAKE_COMMAND} -D "FOLDERS=${lumi_cross}/core;${lumi_policies}" -D ROOTS=^_ZN4lumi8policies4draw
      -D LIMIT=${LUMI_STACK_LIMIT} -P ${CMAKE_CURRENT_SOURCE_DIR}/check_stack.cmake)
  add_test(NAME ${cpu}.core_stack_spans
    COMMAND ${CMAKE_COMMAND} -D "FOLDERS=${lumi_cross}/core;${lumi_policies}" -D ROOTS=^_ZN4lumi8policies10draw_spans
      -D LIMIT=${LUMI_SPAN_STACK_LIMIT} -P ${CMAKE_CURRENT_SOURCE_DIR}/check_stack.cmake)
  add_test(NAME ${cpu}.core_stack_surface
    COMMAND ${CMAKE_COMMAND} -D "FOLDERS=${lumi_cross}/core;${lumi_policies}"
      -D "ROOTS=^_ZN4lumi8policies[0-9]+(prepare_surface|draw_surface)"
      -D LIMIT=${LUMI_SURFACE_STACK_LIMIT} -P ${CMAKE_CURRENT_SOURCE_DIR}/check_stack.cmake)
  add_test(NAME ${cpu}.plain_firmware_links_no_feature
    COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm}
      -D FILES=${lumi_firmware}/lumi_frame_crcs_firmware.elf
      -D "FORBIDDEN=${lumi_see_through_symbols};${lumi_part_symbols};${lumi_state_symbols};${lumi_gloss_symbols}"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
  add_test(NAME ${cpu}.c_firmware_links_what_it_calls
    COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D FILES=${lumi_cross}/tests/cross/lumi_three_calls.elf
      -D "FORBIDDEN=${lumi_other_calls};${lumi_see_through_symbols};${lumi_part_symbols};${lumi_state_symbols};${lumi_gloss_symbols};${lumi_chord_symbols}"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
  add_test(NAME ${cpu}.plain_firmware_links_no_view_tables
    COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D FILES=${lumi_cross}/tests/cross/lumi_plain_view.elf
      -D "FORBIDDEN=${lumi_view_table_symbols}" -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
  list(APPEND lumi_cpu_tests ${cpu}.c_firmware_links_what_it_calls ${cpu}.plain_firmware_links_no_view_tables)
  list(APPEND lumi_cpu_tests ${cpu}.plain_firmware_links_no_feature ${cpu}.core_symbols ${cpu}.core_stack ${cpu}.core_stack_spans ${cpu}.core_stack_surface)
  set_tests_properties(${lumi_cpu_tests} PROPERTIES FIXTURES_REQUIRED lumi_built_${cpu}
    TIMEOUT ${lumi_run_timeout_s})
endforeach()

# The board that stands for an M0+ faults where an M0+ would.
add_test(NAME cortex-m0plus.unaligned_read_faults
  COMMAND ${CMAKE_COMMAND} -D CPU=cortex-m0plus -D ARGUMENTS=unaligned
    -D PROGRAM=${PROJECT_BINARY_DIR}/cross/cortex-m0plus/tests/cross/lumi_board_test.elf
    -P ${PROJECT_SOURCE_DIR}/platform/mps2/run.cmake)
set_tests_properties(cortex-m0plus.unaligned_read_faults PROPERTIES FIXTURES_REQUIRED lumi_built_cortex-m0plus
  PASS_REGULAR_EXPRESSION "fault: .*ended with 70")

foreach(cpu cortex-m0plus cortex-m4)
  lumi_names_test(${cpu}.own_names firmware ${LUMI_FOUND_arm_none_eabi_g__} -mcpu=${cpu})
endforeach()

# A firmware project of somebody else takes core in.
add_test(NAME platform.add_subdirectory_firmware
  COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${lumi_consumer} ${lumi_consumer_build}/firmware
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DLUMI_SOURCE_DIR=${PROJECT_SOURCE_DIR} ${lumi_consumer_field}
      -DCMAKE_TOOLCHAIN_FILE=${PROJECT_SOURCE_DIR}/toolchains/cortex-m0plus.cmake)

# Core's archives compile as each ecosystem compiles them.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME platform.packages
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/packages_test.py $<$<BOOL:${LUMI_TEST_ALL}>:--all>
    $<TARGET_FILE:lumi> ${CMAKE_CURRENT_BINARY_DIR}/fields/surface.lumi ${CMAKE_CURRENT_BINARY_DIR}/packages
    COMMAND_EXPAND_LISTS)
set_tests_properties(platform.packages PROPERTIES FIXTURES_SETUP lumi_archives)
add_test(NAME platform.channels
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/channels_test.py $<$<BOOL:${LUMI_TEST_ALL}>:--all>
    ${CMAKE_CURRENT_BINARY_DIR}/packages/archives
  COMMAND_EXPAND_LISTS)
set_tests_properties(platform.channels PROPERTIES FIXTURES_REQUIRED lumi_archives)

# Arduino's library by arduino-builder, its sketches on an emulated board; `tools/test.sh --all` fails without the builder.
add_test(NAME platform.arduino
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/arduino_test.py $<TARGET_FILE:lumi>
    ${CMAKE_CURRENT_BINARY_DIR}/fields/surface.lumi ${CMAKE_CURRENT_BINARY_DIR}/packages/archives
    ${CMAKE_CURRENT_BINARY_DIR}/arduino)
set_tests_properties(platform.arduino PROPERTIES FIXTURES_REQUIRED lumi_archives COST 60)
if(NOT LUMI_TEST_ALL)
  set_tests_properties(platform.arduino PROPERTIES SKIP_RETURN_CODE 77)
endif()

# The proof finds what is planted for it. These need the build of one CPU.
set(lumi_planted ${PROJECT_BINARY_DIR}/cross/cortex-m0plus/tests/cross)
set(lumi_proof_tests)
foreach(violation float double heap new exception rtti)
  add_test(NAME proof.finds_${violation}
    COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D EXPECT_VIOLATION=ON
      -D FILES=${lumi_planted}/liblumi_planted_${violation}.a -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
  list(APPEND lumi_proof_tests proof.finds_${violation})
endforeach()
add_test(NAME proof.finds_surface
  COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D EXPECT_VIOLATION=ON
    -D FILES=${PROJECT_BINARY_DIR}/cross/cortex-m0plus/platform/mps2/lumi_frame_crcs_firmware.elf
    -D "FORBIDDEN=${lumi_surface_symbols}" -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
list(APPEND lumi_proof_tests proof.finds_surface)
add_test(NAME proof.finds_view_tables
  COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D EXPECT_VIOLATION=ON
    -D FILES=${PROJECT_BINARY_DIR}/cross/cortex-m0plus/tests/cross/lumi_three_calls.elf
    -D "FORBIDDEN=${lumi_view_table_symbols}" -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
add_test(NAME proof.finds_moving_parts
  COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D EXPECT_VIOLATION=ON
    -D FILES=${PROJECT_BINARY_DIR}/cross/cortex-m0plus/core/liblumi_core.a
    -D "FORBIDDEN=${lumi_part_symbols}" -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
add_test(NAME proof.finds_states
  COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D EXPECT_VIOLATION=ON
    -D FILES=${PROJECT_BINARY_DIR}/cross/cortex-m0plus/core/liblumi_core.a
    -D "FORBIDDEN=${lumi_state_symbols}" -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
add_test(NAME proof.finds_gloss
  COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D EXPECT_VIOLATION=ON
    -D FILES=${PROJECT_BINARY_DIR}/cross/cortex-m0plus/core/liblumi_core.a
    -D "FORBIDDEN=${lumi_gloss_symbols}" -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
list(APPEND lumi_proof_tests proof.finds_view_tables proof.finds_moving_parts proof.finds_states proof.finds_gloss)
foreach(what other_calls chord_symbols)
  add_test(NAME proof.finds_${what}
    COMMAND ${CMAKE_COMMAND} -D NM=${LUMI_FOUND_arm_none_eabi_nm} -D EXPECT_VIOLATION=ON
      -D FILES=${lumi_planted}/lumi_bad_chord.elf -D "FORBIDDEN=${lumi_${what}}"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/check_symbols.cmake)
  list(APPEND lumi_proof_tests proof.finds_${what})
endforeach()
foreach(violation dynamic_frame recursion indirect_call)
  add_test(NAME proof.finds_${violation}
    COMMAND ${CMAKE_COMMAND} -D FOLDERS=${lumi_planted}/CMakeFiles/lumi_planted_${violation}.dir -D ROOTS=planted
      -D LIMIT=${LUMI_STACK_LIMIT} -P ${CMAKE_CURRENT_SOURCE_DIR}/check_stack.cmake)
  list(APPEND lumi_proof_tests proof.finds_${violation})
endforeach()
add_test(NAME proof.finds_deep_stack
  COMMAND ${CMAKE_COMMAND} -D "FOLDERS=${PROJECT_BINARY_DIR}/cross/cortex-m0plus/core" -D ROOTS=^_ZN4lumi -D LIMIT=100
    -P ${CMAKE_CURRENT_SOURCE_DIR}/check_stack.cmake)
set_tests_properties(proof.finds_dynamic_frame PROPERTIES PASS_REGULAR_EXPRESSION "is 'dynamic'")
set_tests_properties(proof.finds_recursion PROPERTIES PASS_REGULAR_EXPRESSION "recursion:")
set_tests_properties(proof.finds_indirect_call PROPERTIES PASS_REGULAR_EXPRESSION "a call through a pointer")
set_tests_properties(proof.finds_deep_stack PROPERTIES PASS_REGULAR_EXPRESSION "are more than the 100")
set_tests_properties(${lumi_proof_tests} proof.finds_deep_stack PROPERTIES FIXTURES_REQUIRED lumi_built_cortex-m0plus)
