# SPDX-License-Identifier: MIT
# A Debian package of the `lumi` command, by CPack: cpack -G DEB in the build tree writes lumipath_VERSION_ARCH.deb.
# Libraries that it depends on are found by dpkg-shlibdeps (dpkg-dev).
include(GNUInstallDirs)
set(lumi_doc ${CMAKE_INSTALL_DATADIR}/doc/lumipath)

file(READ ${PROJECT_SOURCE_DIR}/core/PROJECT.json lumi_project)
string(JSON lumi_maintainer GET "${lumi_project}" maintainer)
string(JSON lumi_email GET "${lumi_project}" email)
set(CPACK_PACKAGE_CONTACT "${lumi_maintainer} <${lumi_email}>")

# Pages and completion come from the help of the command, when it is installed.
install(CODE "
  set(share \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\")
  execute_process(COMMAND python3 -B \"${CMAKE_CURRENT_LIST_DIR}/pages.py\" \"$<TARGET_FILE:lumi>\" \"\${share}\"
    COMMAND_ERROR_IS_FATAL ANY)"
  COMPONENT tool)
file(STRINGS ${PROJECT_SOURCE_DIR}/LICENSE lumi_copyright REGEX "^Copyright")
string(REGEX REPLACE "^Copyright (\\(c\\) )?" "" lumi_copyright "${lumi_copyright}")
file(READ ${PROJECT_SOURCE_DIR}/LICENSE lumi_license)
string(STRIP "${lumi_license}" lumi_license)
string(REPLACE "\n\n" "\n.\n" lumi_license "${lumi_license}")
string(REPLACE "\n" "\n " lumi_license " ${lumi_license}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright.in ${CMAKE_CURRENT_BINARY_DIR}/copyright @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${CMAKE_CURRENT_BINARY_DIR}/changelog @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog
  ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${lumi_doc} COMPONENT tool)

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL tool)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/compress.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME lumipath)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOL_DESCRIPTION
"The command lumi bakes a scene (OBJ, MTL, JSON) into a field: radiance that is
kept for every ray that may be seen. A small integer library draws the field
on microcontrollers, from any viewpoint. lumi also draws fields, compares them
with references, and embeds them into firmware.")
include(CPack)
