# SPDX-License-Identifier: MIT
# Which test runs where: the one list. Everything runs without sanitizers. What is left out below runs by
# `tools/test.sh --all`, which sets LUMI_TEST_ALL. docs/log/tests.md says what each group protects.

# Boards that run core's unit tests: the portable loops and those of DSP instructions. M3 has M0+'s loops, M7 has M4's;
# both draw the frame list and pass the proof.
set(LUMI_UNIT_TEST_CPUS cortex-m0plus cortex-m4)

# Boards that only `tools/test.sh --all` builds: code for M55 is compiled from the sources that M33's is.
set(LUMI_BOARDS_OF_ALL cortex-m55)

# Boards leave these unit tests of core out: they check the accuracy of frames in the list that every board draws.
set(LUMI_UNIT_TEST_HOST_FILES chord/render_spans_test chord/extreme_chord_test surface/extreme_surface_test)
# And these always: boards have no threads.
set(LUMI_UNIT_TEST_THREAD_FILES surface/halves_threads_test)

# Policies whose symbols and stacks the proof reads: all; every pair of two choices; each reconstruction once.
set(LUMI_POLICIES_cortex-m0plus pairs)
set(LUMI_POLICIES_cortex-m4 pairs)
set(LUMI_POLICIES_cortex-m3 each)
set(LUMI_POLICIES_cortex-m7 each)
set(LUMI_POLICIES_cortex-m33 each)
set(LUMI_POLICIES_cortex-m55 each)

# Files that are not built under sanitizers. Statistics and pictures against a reference read no file and index no
# memory that other tests do not; plans, reports and benches come from code that bakes and draws nothing itself; which
# file a command spares, and what it says where stdout is full, is code that the other tests of commands run.
set(LUMI_PLAIN_FILES
  baker/math/sampler_test.cpp
  baker/math/warp_test.cpp
  baker/material/anisotropy_test.cpp
  baker/material/bsdf_test.cpp
  baker/material/glass_test.cpp
  baker/material/sheen_test.cpp
  baker/light/fixtures_test.cpp
  baker/light/light_test.cpp
  baker/trace/agreement_test.cpp
  baker/trace/catcher_test.cpp
  baker/trace/error_gauge_test.cpp
  baker/trace/path_tracer_test.cpp
  baker/trace/volume_test.cpp
  baker/mesh/holes_test.cpp
  baker/volume/flight_test.cpp
  baker/volume/opacity_surface_test.cpp
  baker/chord/field_rays_test.cpp
  tools/metrics/cw_ssim_test.cpp
  tools/metrics/flip_test.cpp
  tools/metrics/psnr_test.cpp
  tools/metrics/ssim_test.cpp
  tools/metrics/steerable_pyramid_test.cpp
  lab/bench/surface_reads_test.cpp
  lab/comparison/baselines_test.cpp
  tools/draw/draw_surface_test.cpp
  tools/quality/quality_test.cpp
  tools/filter/lessons_test.cpp
  tools/filter/training_test.cpp
  tools/planner/cache_model_test.cpp
  tools/planner/chord_plan_test.cpp
  tools/planner/chord_speed_test.cpp
  tools/planner/speed_test.cpp
  tools/planner/surface_plan_test.cpp
  tools/planner/surface_speed_test.cpp
  tools/commands/bake_default_test.cpp
  tools/commands/fit_test.cpp
  tools/commands/report_test.cpp
  tools/commands/scale_test.cpp
  tools/commands/options_test.cpp
  tools/commands/own_files_test.cpp
  tools/commands/standard_streams_test.cpp)

# Tests with these tags are not run under sanitizers either: they bake one scene again and again (stopped, killed, in
# shards), or compare pictures and meshes of several bakes.
set(LUMI_PLAIN_TAGS "~[repeated]~[statistics]")

if(LUMI_SANITIZE AND NOT LUMI_TEST_ALL)
  set(LUMI_TEST_SPEC ${LUMI_PLAIN_TAGS})
else()
  set(LUMI_TEST_SPEC)
  set(LUMI_PLAIN_FILES)
endif()

# lumi_test_program(TARGET AREA FILE...): a program of the tests in tests/AREA that belong to this tree, and its tests.
function(lumi_test_program target area)
  set(sources ${ARGN})
  foreach(file IN LISTS LUMI_PLAIN_FILES)
    if(file MATCHES "^${area}/(.*)")
      if(NOT CMAKE_MATCH_1 IN_LIST sources)
        message(FATAL_ERROR "tests/scope.cmake: tests/${file} is no test of ${target}")
      endif()
      list(REMOVE_ITEM sources ${CMAKE_MATCH_1})
    endif()
  endforeach()
  add_executable(${target} ${sources})
  target_compile_definitions(${target} PRIVATE CATCH_CONFIG_FAST_COMPILE)
  target_link_libraries(${target} PRIVATE lumi_catch_main lumi_options Catch2::Catch2)
  target_precompile_headers(${target} PRIVATE <catch2/catch.hpp> ${LUMI_STD_HEADERS})
  if(LUMI_SANITIZE)
    lumi_tests_by_file(${target} ${area} ${sources})
  else()
    # A test that cannot be run by its name (CMake splits it at a semicolon) fails.
    catch_discover_tests(${target} TEST_PREFIX ${area}. EXTRA_ARGS --warn ${LUMI_NO_TEST_FAILS})
  endif()
endfunction()

# One process a file of tests, where a process is slow to start; what a file's tests share is made once.
function(lumi_tests_by_file target area)
  list(FILTER ARGN INCLUDE REGEX "_test\\.cpp$")
  list(TRANSFORM ARGN REPLACE "^.*/|\\.cpp$" "")
  list(REMOVE_DUPLICATES ARGN)
  foreach(file IN LISTS ARGN)
    add_test(NAME ${LUMI_TEST_PREFIX}${area}.${file}
      COMMAND ${target} --filenames-as-tags --warn ${LUMI_NO_TEST_FAILS} "[#${file}]${LUMI_TEST_SPEC}")
  endforeach()
endfunction()
