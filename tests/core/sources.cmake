# SPDX-License-Identifier: MIT
# Core's tests, for the host and for the emulated boards alike.
set(LUMI_CORE_TEST_SOURCES
  camera_test.cpp
  color_test.cpp
  field_test.cpp
  lattice_test.cpp
  math_test.cpp
  polar_test.cpp
  render_test.cpp
  span_test.cpp
  sphere_test.cpp)
list(TRANSFORM LUMI_CORE_TEST_SOURCES PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
