# SPDX-License-Identifier: MIT
# This is the one list that says which test runs where. `tools/test.sh` runs each file of tests in one tree: under
# sanitizers, or, where it needs speed, without (LUMI_TEST_SHORT). `tools/test.sh --all` (LUMI_TEST_ALL) runs every file
# without sanitizers, and all that is left out below. A tree that is configured by hand without either option has every
# test that its compiler can run. docs/log/tests.md says what each group protects.
set(LUMI_SHORT OFF)
if(LUMI_SANITIZE OR (LUMI_TEST_SHORT AND NOT LUMI_TEST_ALL))
  set(LUMI_SHORT ON)
endif()

# Boards that run core's unit tests: the portable loops and those of DSP instructions. M3 has M0+'s loops, M7, M33 and M55
# have M4's; all draw the frame list and pass the proof. `--all` runs every unit test on these two and the files of
# LUMI_UNIT_TEST_BOARD_FILES on the others.
set(LUMI_UNIT_TEST_CPUS cortex-m0plus cortex-m4)

# Cores for which the RAM and stack of README's firmware are measured. The others' code is as M0+'s or M4's.
set(LUMI_MEMORY_CPUS cortex-m0plus cortex-m4)

# Boards that only `tools/test.sh --all` builds: code for M55 is compiled from the sources that M33's is.
set(LUMI_BOARDS_OF_ALL cortex-m55)

# Unit tests of core that these boards run: those in which another compiler, its calls from C, DSP instructions, the loops in
# assembly or an address that memory does not have can make a difference. That frames are the host's, bit by bit, the
# list of frames shows on every board.
set(LUMI_UNIT_TEST_BOARD_FILES math/math_test field/field_test chord/reads_test pixel/pack_test view/same_bits_test
  c/frames_test)
# Boards have no threads, so they never run these.
set(LUMI_UNIT_TEST_THREAD_FILES surface/halves_threads_test)

# Policies whose symbols and stacks the proof reads: every pair of two choices; each reconstruction once. `--all` reads
# all of them on the boards that run unit tests.
set(LUMI_POLICIES_cortex-m0plus pairs)
set(LUMI_POLICIES_cortex-m4 pairs)
set(LUMI_POLICIES_cortex-m3 each)
set(LUMI_POLICIES_cortex-m7 each)
set(LUMI_POLICIES_cortex-m33 each)
set(LUMI_POLICIES_cortex-m55 each)

# Files and folders of tests that need speed and are not built under sanitizers. Sweeps of formulas and statistics index no
# memory that other tests do not. Plans, reports, benches and command lines are made of code that bakes and draws nothing
# itself. OpenVDB, which reads its own files and makes iso-surfaces, is not built there.
set(LUMI_PLAIN_FILES
  core/lattice/
  core/chord/exact_test.cpp
  core/chord/linear_test.cpp
  core/chord/nine_taps_test.cpp
  core/chord/one_tap_test.cpp
  core/chord/render_spans_test.cpp
  core/chord/sphere_test.cpp
  core/chord/stepping/
  core/field/color_test.cpp
  core/surface/halves_threads_test.cpp
  core/surface/surface_twin_test.cpp
  baker/math/
  baker/material/
  baker/fit/gloss_test.cpp
  baker/light/fixtures_test.cpp
  baker/light/light_test.cpp
  baker/trace/agreement_test.cpp
  baker/trace/error_gauge_test.cpp
  baker/trace/path_tracer_test.cpp
  baker/trace/volume_test.cpp
  baker/mesh/copies_test.cpp
  baker/mesh/holes_test.cpp
  baker/mesh/mesh_outline_test.cpp
  baker/mesh/patch_mesh_test.cpp
  baker/volume/flight_test.cpp
  baker/volume/opacity_surface_test.cpp
  baker/volume/iso_surface_test.cpp
  baker/volume/vdb_file_test.cpp
  baker/surface/surface_bake_test.cpp
  baker/surface/surface_plan_test.cpp
  baker/chord/field_rays_test.cpp
  lab/
  platform/
  tools/)

# Files that both trees run: their full form needs speed and their reads need sanitizers, which run the light form; or their
# bits must be the same whatever the compiler's options; or they hold damaged files beside bakes that are repeated.
set(LUMI_BOTH_FILES
  core/camera/
  core/chord/both_sides_test.cpp
  core/chord/cover_test.cpp
  core/chord/cut_columns_test.cpp
  core/chord/extreme_chord_test.cpp
  core/chord/range_test.cpp
  core/chord/reads_test.cpp
  core/chord/render_test.cpp
  core/field/field_test.cpp
  core/math/
  core/stripes_test.cpp
  core/surface/extreme_surface_test.cpp
  core/surface/halves_test.cpp
  core/surface/render_test.cpp
  core/surface/view_nodes_test.cpp
  core/view/same_bits_test.cpp
  baker/merge_test.cpp
  baker/store/checkpoint_test.cpp
  baker/surface/see_through_bake_test.cpp
  baker/surface/surface_checkpoint_test.cpp)

foreach(entry IN LISTS LUMI_PLAIN_FILES LUMI_BOTH_FILES)
  if(NOT EXISTS ${CMAKE_CURRENT_LIST_DIR}/${entry})
    message(FATAL_ERROR "tests/scope.cmake: there is no tests/${entry}")
  endif()
endforeach()

# Tests with these tags are not run under sanitizers: they bake one scene again and again (stopped, killed, in shards), or
# compare pictures and meshes of several bakes.
set(LUMI_TEST_SPEC)
if(LUMI_SANITIZE)
  set(LUMI_TEST_SPEC "~[repeated]~[statistics]")
endif()

# lumi_in(FILE LIST OUT): whether the list holds the file or a folder of it.
function(lumi_in file list out)
  set(${out} OFF PARENT_SCOPE)
  foreach(entry IN LISTS ${list})
    string(FIND ${file} ${entry} place)
    if(place EQUAL 0)
      set(${out} ON PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# lumi_keep_tests(AREA OUT FILE...): those of the tests in tests/AREA that run in this tree, and the files that are no tests.
function(lumi_keep_tests area out)
  set(kept)
  foreach(file IN LISTS ARGN)
    string(REPLACE ${CMAKE_CURRENT_SOURCE_DIR} "" place /${file})
    string(REGEX REPLACE "^/+" ${area}/ place ${place})
    lumi_in(${place} LUMI_PLAIN_FILES plain)
    lumi_in(${place} LUMI_BOTH_FILES both)
    if(NOT LUMI_SHORT OR NOT file MATCHES "_test\\.cpp$" OR both OR (plain AND NOT LUMI_SANITIZE)
        OR (NOT plain AND LUMI_SANITIZE))
      list(APPEND kept ${file})
    endif()
  endforeach()
  set(${out} ${kept} PARENT_SCOPE)
endfunction()

# lumi_test_program(TARGET AREA FILE...): a program of the tests in tests/AREA that belong to this tree, and its tests:
# one process a file, so that what the file's tests share is made once. Makes no target where no test belongs to this tree.
function(lumi_test_program target area)
  lumi_keep_tests(${area} sources ${ARGN})
  set(files ${sources})
  list(FILTER files INCLUDE REGEX "_test\\.cpp$")
  if(NOT files)
    return()
  endif()
  add_executable(${target} ${sources})
  target_compile_definitions(${target} PRIVATE CATCH_CONFIG_FAST_COMPILE)
  target_link_libraries(${target} PRIVATE lumi_catch_main lumi_options Catch2::Catch2)
  target_precompile_headers(${target} PRIVATE <catch2/catch.hpp> ${LUMI_STD_HEADERS})
  list(TRANSFORM files REPLACE "^.*/|\\.cpp$" "")
  list(REMOVE_DUPLICATES files)
  foreach(file IN LISTS files)
    add_test(NAME ${LUMI_TEST_PREFIX}${area}.${file}
      COMMAND ${target} --filenames-as-tags --warn ${LUMI_NO_TEST_FAILS} "[#${file}]${LUMI_TEST_SPEC}")
  endforeach()
endfunction()
