# SPDX-License-Identifier: MIT
# The example's programs behind the start-up code and the drivers of the Pico SDK, with core as pico_lumi.
pico_sdk_init()
include(${lumi_root}/core/pico_lumi.cmake)

# lumi_pico_sdk_program(NAME SOURCE...): its first source has main().
function(lumi_pico_sdk_program name)
  list(GET ARGN 0 main)
  add_executable(${name} ${ARGN} sdk/bus.cpp sdk/chip.cpp sdk/main.cpp ../mps2/firmware/text_line.cpp)
  set_source_files_properties(${main} PROPERTIES COMPILE_DEFINITIONS main=firmware_main)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} sdk ../bare ../mps2/firmware)
  target_link_libraries(${name} PRIVATE pico_lumi pico_runtime pico_standard_link
    hardware_dma hardware_gpio hardware_spi hardware_timer hardware_uart)
  lumi_add_field(${name} FIELD ${LUMI_EXAMPLE_FIELD} SYMBOL desk_clock)
endfunction()
