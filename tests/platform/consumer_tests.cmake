# SPDX-License-Identifier: MIT
# A project that knows nothing of this one uses core in the two ways that docs/boards.md shows.
set(lumi_consumer ${CMAKE_CURRENT_SOURCE_DIR}/consumer)
set(lumi_consumer_build ${CMAKE_CURRENT_BINARY_DIR}/consumer)
set(lumi_test_prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)
set(lumi_consumer_options -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
  -DCMAKE_EXE_LINKER_FLAGS=$<$<BOOL:${LUMI_SANITIZE}>:-fsanitize=address,undefined>)

add_test(NAME ${LUMI_TEST_PREFIX}platform.install
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${lumi_test_prefix})
set_tests_properties(${LUMI_TEST_PREFIX}platform.install PROPERTIES FIXTURES_SETUP ${LUMI_TEST_PREFIX}lumi_installed)

add_test(NAME ${LUMI_TEST_PREFIX}platform.find_package
  COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${lumi_consumer} ${lumi_consumer_build}/find_package
    --build-generator ${CMAKE_GENERATOR} --build-options ${lumi_consumer_options}
      -DCMAKE_PREFIX_PATH=${lumi_test_prefix}
    --test-command consumer ${CMAKE_CURRENT_BINARY_DIR}/fields/rgb565.lumi)
set_tests_properties(${LUMI_TEST_PREFIX}platform.find_package PROPERTIES
  FIXTURES_REQUIRED ${LUMI_TEST_PREFIX}lumi_installed)

add_test(NAME ${LUMI_TEST_PREFIX}platform.add_subdirectory
  COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${lumi_consumer} ${lumi_consumer_build}/add_subdirectory
    --build-generator ${CMAKE_GENERATOR} --build-options ${lumi_consumer_options}
      -DLUMI_SOURCE_DIR=${PROJECT_SOURCE_DIR}
    --test-command consumer ${CMAKE_CURRENT_BINARY_DIR}/fields/rgb565.lumi)

# What README.md and core/README.md print compiles and draws, in C++ and in C (C99, -pedantic), the same frame.
add_test(NAME ${LUMI_TEST_PREFIX}platform.snippets
  COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/snippets ${lumi_consumer_build}/snippets
    --build-generator ${CMAKE_GENERATOR} --build-options ${lumi_consumer_options}
      -DCMAKE_PREFIX_PATH=${lumi_test_prefix} -DLUMI_SOURCE_DIR=${PROJECT_SOURCE_DIR}
      -DFIELD=${CMAKE_CURRENT_BINARY_DIR}/fields/surface.lumi
      -DLUMI_TOOL=$<TARGET_FILE:lumi>)
set_tests_properties(${LUMI_TEST_PREFIX}platform.snippets PROPERTIES
  FIXTURES_REQUIRED ${LUMI_TEST_PREFIX}lumi_installed)
