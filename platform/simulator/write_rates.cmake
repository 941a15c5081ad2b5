# SPDX-License-Identifier: MIT
# cmake -D LUMI=command -D FIELD=file -D OUT=header -P write_rates.cmake
# Writes what `lumi inspect --screen` says of the field, in the mode that the example draws, as a list for C++.
cmake_minimum_required(VERSION 3.19)
execute_process(COMMAND ${LUMI} inspect ${FIELD} --screen 240x240 --json OUTPUT_VARIABLE report COMMAND_ERROR_IS_FATAL ANY)
string(JSON count LENGTH "${report}" frames_per_second antialiased)
math(EXPR last "${count} - 1")
set(rows)
foreach(k RANGE ${last})
  string(JSON chip MEMBER "${report}" frames_per_second antialiased ${k})
  string(JSON rate GET "${report}" frames_per_second antialiased ${chip})
  string(APPEND rows "    {\"${chip}\", ${rate}},\n")
endforeach()
file(WRITE ${OUT} "// written by write_rates.cmake: modelled frames a second of named chips\nconstexpr Rate kRates[] = {\n${rows}};\n")
