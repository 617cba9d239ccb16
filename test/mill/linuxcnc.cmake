# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
# LinuxCNC's interpreter reads the program of the sample to its end.
cmake_minimum_required(VERSION 3.22)

find_program(RS274 rs274)
if(NOT RS274)
  message(STATUS "SKIPPED: LinuxCNC's rs274 is not installed")
  return()
endif()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(
  COMMAND ${PROGRAM} mill ${DATA}/sample_scan.pcd -o ${WORK}/nc --quiet
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "pointmill: exit code ${status}")
endif()
set(tools "")
foreach(tool RANGE 1 9)
  string(APPEND tools "T${tool} P${tool} Z0 D10\n")
endforeach()
file(WRITE ${WORK}/tool.tbl "${tools}")
file(WRITE ${WORK}/parameters "5161\t0.000000\n")
file(WRITE ${WORK}/nothing "")
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env HOME=${WORK} ${RS274} -g -n 2 -t tool.tbl
          -v parameters nc/program.ngc calls.txt
  WORKING_DIRECTORY ${WORK}
  INPUT_FILE ${WORK}/nothing
  RESULT_VARIABLE status
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output
  TIMEOUT 300)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "rs274: ${status}\n${output}")
endif()
file(SIZE ${WORK}/calls.txt size)
if(size LESS 100000)
  message(FATAL_ERROR "rs274 made only ${size} bytes of calls")
endif()
math(EXPR tail "${size} - 400")
file(READ ${WORK}/calls.txt last OFFSET ${tail})
# Of what follows the program's end is only the interpreter's own reset.
if(NOT last MATCHES "PROGRAM_END\\(\\)([ \r\n]+[0-9]+ N[.]+ +ON_RESET\\(\\))*[ \r\n]*$")
  message(FATAL_ERROR "the calls do not end with PROGRAM_END:\n${last}")
endif()
file(REMOVE_RECURSE ${WORK})
