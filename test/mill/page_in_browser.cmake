# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
# A job's pages in a browser without a screen: no console error, the 3D view is drawn and
# does what its controls say, and without scripts all that is text is there.
cmake_minimum_required(VERSION 3.22)

find_program(CHROMIUM NAMES chromium chromium-browser google-chrome)
if(NOT CHROMIUM)
  message(STATUS "SKIPPED: Chromium is not installed")
  return()
endif()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# browse(PAGE RESULT OPTIONS ...): the document after its scripts have run. What a page
# writes on its console is an error, as ours write nothing.
function(browse page result)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env HOME=${WORK}
            ${CHROMIUM} --headless --no-sandbox --disable-dev-shm-usage --no-first-run
            --disable-background-networking --disable-component-update
            --user-data-dir=${WORK}/profile --window-size=1280,1000
            --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader
            --enable-logging=stderr ${ARGN}
            --dump-dom file://${page}
    RESULT_VARIABLE status
    OUTPUT_VARIABLE document
    ERROR_VARIABLE log
    TIMEOUT 120)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "Chromium: ${status}\n${log}")
  endif()
  string(REGEX MATCHALL "[^\n]*CONSOLE[^\n]*" console "${log}")
  if(console)
    message(FATAL_ERROR "${page}: ${console}")
  endif()
  set(${result} "${document}" PARENT_SCOPE)
endfunction()

function(must_hold document)
  foreach(text ${ARGN})
    string(FIND "${document}" "${text}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "the page does not hold ${text}")
    endif()
  endforeach()
endfunction()

# A name that would be markup, and end a script, if it were not escaped.
set(scan "${WORK}/<script>alert(1)<!--.pcd")
configure_file(${DATA}/stairs.pcd ${scan} COPYONLY)

# mill(CODE FILE OPTIONS ...): the page FILE, with the test's script in a copy of it
function(mill code file)
  execute_process(
    COMMAND ${PROGRAM} mill ${scan} -o ${WORK}/nc --quiet
            --keep-out "box:-20,10,-12,20,4" --stock-margin 3 ${ARGN}
    RESULT_VARIABLE status
    ERROR_VARIABLE error)
  if(NOT status EQUAL code)
    message(FATAL_ERROR "pointmill: exit code ${status}\n${error}")
  endif()
  file(READ ${WORK}/nc/${file} page)
  file(READ ${SCRIPT} script)
  string(REPLACE "</body>" "<script>${script}</script></body>" page "${page}")
  file(WRITE ${WORK}/tested.html "${page}")
endfunction()

mill(0 report.html)
browse(${WORK}/nc/report.html document)
must_hold("${document}" "data-view=\"ready\"" "Set-up sheet"
          "<h1>&lt\;script&gt\;alert(1)&lt\;!--.pcd</h1>")
browse(${WORK}/tested.html document)
if(NOT document MATCHES "data-test=\"passed\"")
  string(REGEX MATCH "data-[a-z]+=\"[^\"]*\"( data-[a-z]+=\"[^\"]*\")*" said "${document}")
  message(FATAL_ERROR "the page in use: ${said}")
endif()
# On a telephone's width, which no window of Chromium's has: in a frame of that width.
configure_file(${NARROW} ${WORK}/narrow.html COPYONLY)
browse(${WORK}/narrow.html document --allow-file-access-from-files --hide-scrollbars)
if(NOT document MATCHES "data-test=\"passed\"")
  string(REGEX MATCH "data-test=\"[^\"]*\"" said "${document}")
  message(FATAL_ERROR "the narrow page: ${said}")
endif()
# Chromium's dump is a script itself, so those of the page are switched off one by one.
file(READ ${WORK}/nc/report.html page)
string(REPLACE "<script" "<script type=\"text/plain\"" page "${page}")
file(WRITE ${WORK}/still.html "${page}")
browse(${WORK}/still.html document)
if(document MATCHES "data-view=")
  message(FATAL_ERROR "scripts ran")
endif()
must_hold("${document}" "<caption>Tools</caption>" "What each operation does"
          "Scan, tool paths and milled part side by side" "<table>")
# Without WebGL a sentence says so, and the picture stays.
browse(${WORK}/nc/report.html document --disable-gpu --disable-3d-apis)
must_hold("${document}" "data-view=\"missing\"")

# The page of a check, of a program with the wrong tool, has sections of what is found.
file(READ ${WORK}/nc/program.ngc program)
string(REPLACE "T3 M6\nG43 H3" "T1 M6\nG43 H1" program "${program}")
file(WRITE ${WORK}/wrong.ngc "${program}")
execute_process(
  COMMAND ${PROGRAM} check ${WORK}/wrong.ngc --dir ${WORK}/nc --quiet
          --report ${WORK}/check.html
  RESULT_VARIABLE status)
if(NOT status EQUAL 3)
  message(FATAL_ERROR "check: exit code ${status}")
endif()
browse(${WORK}/check.html document)
must_hold("${document}" "data-view=\"ready\"" "Refused: "
          "Section through the place of finding 1")

mill(3 refused.html --finish-allowance 0.3 --residual-limit 0.05)
browse(${WORK}/nc/refused.html document)
must_hold("${document}" "data-view=\"ready\"" "Refused: no program was written")
file(REMOVE_RECURSE ${WORK})
