# SPDX-License-Identifier: MIT
# Before CPack makes the package: what Debian wants compressed, without names and times inside.
file(GLOB_RECURSE files LIST_DIRECTORIES false "${CPACK_TEMPORARY_DIRECTORY}/*")
list(FILTER files INCLUDE REGEX "/man1/[^/]*\\.1$|/doc/[^/]*/changelog$")
execute_process(COMMAND gzip --best --no-name --force ${files} COMMAND_ERROR_IS_FATAL ANY)
