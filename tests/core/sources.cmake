# SPDX-License-Identifier: MIT
# Core's tests, for the host and for the emulated boards alike.
set(LUMI_CORE_TEST_SOURCES
  camera_test.cpp
  color_test.cpp
  field_test.cpp
  focus_surface_test.cpp
  guided_field_test.cpp
  guided_hostile_test.cpp
  guided_render_test.cpp
  guided_shade_test.cpp
  lattice_test.cpp
  linear_light_test.cpp
  math_test.cpp
  polar_test.cpp
  proxy_stripes_test.cpp
  proxy_test.cpp
  quality_test.cpp
  render_test.cpp
  span_cover_test.cpp
  span_loop_test.cpp
  span_node_test.cpp
  span_nine_test.cpp
  span_pair_test.cpp
  span_range_test.cpp
  span_reads_test.cpp
  span_test.cpp
  span_rim_test.cpp
  span_tile_test.cpp
  sphere_test.cpp)
list(TRANSFORM LUMI_CORE_TEST_SOURCES PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
