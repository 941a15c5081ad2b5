# SPDX-License-Identifier: MIT
# Core's tests, for the host and for the emulated boards alike.
set(LUMI_CORE_TEST_SOURCES
  chord/render_test.cpp
  stripes_test.cpp
  camera/attitude_test.cpp
  camera/camera_test.cpp
  camera/orbit_test.cpp
  chord/sphere_test.cpp
  chord/cover_test.cpp
  chord/cut_columns_test.cpp
  chord/exact_test.cpp
  chord/extreme_chord_test.cpp
  chord/linear_test.cpp
  chord/nine_taps_test.cpp
  chord/one_tap_test.cpp
  chord/both_sides_test.cpp
  chord/range_test.cpp
  chord/reads_test.cpp
  chord/render_spans_test.cpp
  chord/tile_test.cpp
  field/color_test.cpp
  field/field_test.cpp
  lattice/lattice_test.cpp
  lattice/polar_test.cpp
  lattice/triangle_test.cpp
  math/math_test.cpp
  chord/stepping/hits_test.cpp
  chord/stepping/lattice_line_test.cpp
  surface/coverage_test.cpp
  surface/extreme_surface_test.cpp
  surface/halves_test.cpp
  surface/halves_threads_test.cpp
  surface/part_records_test.cpp
  surface/parts_test.cpp
  surface/planes_test.cpp
  surface/render_test.cpp
  surface/see_through_test.cpp
  surface/state_records_test.cpp
  surface/states_test.cpp
  surface/field_test.cpp
  surface/surface_twin_test.cpp
  surface/view_nodes_test.cpp
  view/c_api_test.cpp
  c/control_test.cpp
  c/frames_test.cpp
  c/memory_test.cpp
  c/parts_test.cpp
  c/states_test.cpp
  control/gesture_test.cpp
  control/quality_test.cpp
  pixel/pack_test.cpp
  view/same_bits_test.cpp
  view/small_screens_test.cpp
  view/view_test.cpp)
list(TRANSFORM LUMI_CORE_TEST_SOURCES PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
# Helpers that tests share lie here; tests look into core, too.
set(LUMI_CORE_TEST_INCLUDES ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/../../core/src)
