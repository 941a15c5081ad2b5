# SPDX-License-Identifier: MIT
# The examples of platform/ on emulated devices: tools/lab/devices.sh builds each, runs it and compares its pictures, bit by
# bit. Without an emulator its test is skipped; `tools/test.sh --all` fails instead.
add_executable(lumi_device_picture device_picture.cpp)
target_link_libraries(lumi_device_picture PRIVATE lumi::core lumi::host lumi_options)

set(lumi_devices ${PROJECT_SOURCE_DIR}/tools/lab/devices.sh --built)
if(NOT LUMI_TEST_ALL)
  list(APPEND lumi_devices --may-skip)
endif()
add_test(NAME devices.field COMMAND ${lumi_devices} --only field)
set_tests_properties(devices.field PROPERTIES FIXTURES_SETUP lumi_device_field COST 300)
foreach(example riscv lm3s_oled pico_st7789 simulator overlay clock)
  add_test(NAME devices.${example} COMMAND ${lumi_devices} --only ${example})
  set_tests_properties(devices.${example} PROPERTIES FIXTURES_REQUIRED lumi_device_field SKIP_RETURN_CODE 77
    COST 200 TIMEOUT 600)
endforeach()
set_tests_properties(devices.overlay PROPERTIES DEPENDS "devices.riscv;devices.simulator")  # which build its programs
set_tests_properties(devices.clock PROPERTIES DEPENDS "devices.pico_st7789;devices.overlay")  # likewise

# RAM and stack that docs/firmware.md states for README's firmware, measured.
set(lumi_memory_cpus ${LUMI_MEMORY_CPUS})
if(LUMI_TEST_ALL)
  set(lumi_memory_cpus ${lumi_cpus})
endif()
add_test(NAME devices.memory COMMAND ${PROJECT_SOURCE_DIR}/tools/lab/board_memory.sh --check ${lumi_memory_cpus})
set_tests_properties(devices.memory PROPERTIES FIXTURES_REQUIRED lumi_device_field)
