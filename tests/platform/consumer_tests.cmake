# SPDX-License-Identifier: MIT
# A project that knows nothing of this one uses core in the two ways that core/README.md shows.
set(lumi_consumer ${CMAKE_CURRENT_SOURCE_DIR}/consumer)
set(lumi_consumer_build ${CMAKE_CURRENT_BINARY_DIR}/consumer)
set(lumi_test_prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)
set(lumi_consumer_options -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
  -DCMAKE_EXE_LINKER_FLAGS=$<$<BOOL:${LUMI_SANITIZE}>:-fsanitize=address,undefined>)

add_test(NAME ${LUMI_TEST_PREFIX}platform.install
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${lumi_test_prefix})
set_tests_properties(${LUMI_TEST_PREFIX}platform.install PROPERTIES FIXTURES_SETUP ${LUMI_TEST_PREFIX}lumi_installed)

# A project in C and C++ needs no more languages to take a field in; one without C++ is told so.
set(lumi_consumer_field -DFIELD=${CMAKE_CURRENT_BINARY_DIR}/fields/rgb565.lumi -DLUMI_TOOL=$<TARGET_FILE:lumi>)
function(lumi_consumer_test name)
  add_test(NAME ${LUMI_TEST_PREFIX}platform.${name}
    COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${lumi_consumer} ${lumi_consumer_build}/${name}
      --build-generator ${CMAKE_GENERATOR} --build-options ${lumi_consumer_options} ${lumi_consumer_field} ${ARGN}
      --test-command consumer)
  if(name MATCHES "find_package")
    set_tests_properties(${LUMI_TEST_PREFIX}platform.${name} PROPERTIES
      FIXTURES_REQUIRED ${LUMI_TEST_PREFIX}lumi_installed)
  endif()
  if(name MATCHES "without_cxx")
    set_tests_properties(${LUMI_TEST_PREFIX}platform.${name} PROPERTIES
      PASS_REGULAR_EXPRESSION "project\\(NAME LANGUAGES C CXX\\)")
  endif()
endfunction()
lumi_consumer_test(find_package -DCMAKE_PREFIX_PATH=${lumi_test_prefix})
lumi_consumer_test(find_package_without_cxx -DCMAKE_PREFIX_PATH=${lumi_test_prefix} -DCONSUMER_LANGUAGES=C)
lumi_consumer_test(add_subdirectory -DLUMI_SOURCE_DIR=${PROJECT_SOURCE_DIR})
lumi_consumer_test(add_subdirectory_of_core -DLUMI_SOURCE_DIR=${PROJECT_SOURCE_DIR}/core -DCONSUMER_LANGUAGES=CXX)
lumi_consumer_test(add_subdirectory_without_cxx -DLUMI_SOURCE_DIR=${PROJECT_SOURCE_DIR}/core -DCONSUMER_LANGUAGES=C)

# The code that README.md and core/README.md print compiles and draws, in C++ and in C (C99, -pedantic), the same frame.
add_test(NAME ${LUMI_TEST_PREFIX}platform.snippets
  COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/snippets ${lumi_consumer_build}/snippets
    --build-generator ${CMAKE_GENERATOR} --build-options ${lumi_consumer_options}
      -DCMAKE_PREFIX_PATH=${lumi_test_prefix} -DLUMI_SOURCE_DIR=${PROJECT_SOURCE_DIR}
      -DFIELD=${CMAKE_CURRENT_BINARY_DIR}/fields/surface.lumi
      -DLUMI_TOOL=$<TARGET_FILE:lumi>)
set_tests_properties(${LUMI_TEST_PREFIX}platform.snippets PROPERTIES
  FIXTURES_REQUIRED ${LUMI_TEST_PREFIX}lumi_installed)
