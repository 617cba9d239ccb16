# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
# Exit codes and messages of the program: 0 good, 1 usage, 2 bad input, 3 refused.
cmake_minimum_required(VERSION 3.22)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# run(CODE WORDS ARGUMENTS ...): exits with CODE; an error is one line on stderr that
# begins with the program's name and holds WORDS; nothing is left behind.
function(run code words)
  execute_process(
    COMMAND ${PROGRAM} ${ARGN}
    WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE status
    OUTPUT_VARIABLE output
    ERROR_VARIABLE error)
  string(JOIN " " call ${ARGN})
  set(seen "pointmill ${call}\n  exit code ${status}\n  stdout: ${output}\n  stderr: ${error}")
  if(NOT status STREQUAL code)
    message(SEND_ERROR "exit code ${code} was expected of ${seen}")
  endif()
  if(code GREATER 1)
    if(NOT error MATCHES "^pointmill: [^\n]+\n$" AND NOT code EQUAL 3)
      message(SEND_ERROR "one line on stderr was expected of ${seen}")
    endif()
    if(NOT output STREQUAL "")
      message(SEND_ERROR "nothing on stdout was expected of ${seen}")
    endif()
    if(EXISTS ${WORK}/out)
      message(SEND_ERROR "no directory was expected of ${seen}")
    endif()
  endif()
  if(code EQUAL 0)
    set(text "${output}")
    if(NOT error STREQUAL "")
      message(SEND_ERROR "nothing on stderr was expected of ${seen}")
    endif()
  else()
    set(text "${error}")
  endif()
  if(NOT words STREQUAL "" AND NOT text MATCHES "${words}")
    message(SEND_ERROR "\"${words}\" was expected of ${seen}")
  endif()
  file(GLOB rest ${WORK}/.*partial* ${WORK}/*partial*)
  if(rest)
    message(SEND_ERROR "${rest} stays after ${seen}")
  endif()
endfunction()

run(0 "^pointmill [0-9]+\\.[0-9]+\\.[0-9]+\n$" --version)
run(0 "mill" --help)
run(0 "--tolerance" mill --help)

# 1: usage
run(1 "" )
run(1 "" mill)
run(1 "" grind ${DATA}/dome.pcd)
run(1 "--no-such-option" mill ${DATA}/dome.pcd --no-such-option)
run(1 "--no-such-option" mill --no-such-option)
run(1 "--no-such-option" --no-such-option)
run(1 "SCAN is required" mill -o out)
run(1 "--tolerance" mill ${DATA}/dome.pcd -o out --tolerance wide)
run(1 "--tolerance" mill ${DATA}/dome.pcd -o out --tolerance 5)
run(1 "--tolerance" mill ${DATA}/dome.pcd -o out --tolerance nan)
run(1 "--units" mill ${DATA}/dome.pcd -o out --units furlong)
run(1 "" mill ${DATA}/dome.pcd -o out --rough-diameter -3)
# ... of the tools, whose options come in any order
function(no_tool words)
  run(1 "${words}" mill ${DATA}/dome.pcd -o out ${ARGN})
endfunction()
no_tool("--rough-type must be flat.*not drill" --rough-type drill)
no_tool("--finish-type taper needs --finish-tip" --finish-type taper --finish-taper 5)
no_tool("--semi-type bull needs --semi-corner" --semi-type bull)
no_tool("--finish-taper does not befit --finish-type ball" --finish-taper 5)
no_tool("--semi-corner does not befit --semi-type ball" --semi-corner 1)
no_tool("--rough-corner does not befit --rough-type cone"
        --rough-type cone --rough-taper 30 --rough-corner 1)
no_tool("corner radius is 2 mm; it must lie in 0 .. 1.25 mm"
        --semi-corner 2 --semi-diameter 2.5 --semi-type bull)
no_tool("corner radius is 2 mm; it must lie in 0 .. 1.25 mm"
        --semi-type bull --semi-diameter 2.5 --semi-corner 2)
no_tool("tip diameter is 4 mm" --finish-tip 4 --finish-taper 5 --finish-type taper)
no_tool("taper is 90 deg" --finish-tip 1 --finish-taper 90 --finish-type taper)
no_tool("T3 flat 3 mm has no round" --finish-type flat)
no_tool("T2 cone 5 mm, 30 deg has no round" --semi-type cone --semi-taper 30)
if(EXISTS ${WORK}/out)
  message(SEND_ERROR "a directory was made though the options are wrong")
endif()

# ... of cutting data
function(no_cut words)
  run(1 "${words}" cutting ${ARGN})
endfunction()
no_cut("--material is needed")
no_cut("unknown material 'hartwood', did you mean 'hardwood'" --material hartwood)
no_cut("--type must be flat.*not drill" --material brass --type drill)
no_cut("--type taper needs --taper" --material brass --type taper)
no_cut("--cut must be roughing" --material brass --cut planing)
no_cut("chip load is 5 mm" --material brass --diameter 6 --chip-load 5)
no_cut("--length is nan" --material brass --length nan)
no_cut("pointmill cutting --help" --material brass --no-such-option)
run(0 "hardened-steel  .* no .*graphite" cutting --list)
run(0 "n +9549 rev/min\n.*vf +2339 mm/min\n" # 3e5 / 10 pi; 0.08 / (2 sqrt(0.24))
    cutting --material Aluminum --diameter 10 --flutes 3)
run(0 "18000 rev/min  <- max spindle\n.* <- max feed, power\n.*<- it rubs\n.*1000 mm +[0-9.]+ min"
    cutting --material hardwood --type ball --diameter 6 --max-spindle 18000
    --max-feed 2000 --power 10 --length 1000)

run(1 "--material needs --max-spindle" mill ${DATA}/dome.pcd -o out --material brass)
run(1 "did you mean" mill ${DATA}/dome.pcd -o out --material bras --max-spindle 24000)
run(1 "T3 ball 3 mm: spindle is 16000 rpm" mill ${DATA}/dome.pcd -o out
    --max-spindle 12000)

# 2: bad input
run(2 "missing.pcd" mill missing.pcd -o out)
file(WRITE ${WORK}/garbage.pcd "this is no point cloud\n")
run(2 "garbage.pcd" mill garbage.pcd -o out)
file(WRITE ${WORK}/garbage.stl "nor is this\n")
run(2 "garbage.stl" mill garbage.stl -o out)
file(WRITE ${WORK}/scan.docx "x")
run(2 "scan.docx" mill scan.docx -o out)
file(WRITE ${WORK}/empty.pcd "")
run(2 "empty.pcd" mill empty.pcd -o out)
file(MAKE_DIRECTORY ${WORK}/folder.pcd)
run(2 "folder.pcd" mill folder.pcd -o out)
find_program(HEAD head REQUIRED)
foreach(bytes 100 50000 150000)
  execute_process(
    COMMAND ${HEAD} -c ${bytes} ${DATA}/dome.pcd OUTPUT_FILE ${WORK}/cut.pcd)
  run(2 "cut.pcd" mill cut.pcd -o out)
endforeach()
run(2 "60 m.*--units" mill ${DATA}/dome.pcd -o out --units m)
run(2 "is a file" mill ${DATA}/dome.pcd -o garbage.pcd)
file(COPY ${DATA}/dome.pcd DESTINATION ${WORK}/here)
file(RENAME ${WORK}/here/dome.pcd ${WORK}/here/part.pcd)
run(2 "overwritten" mill here/part.pcd -o here)
file(GLOB here RELATIVE ${WORK}/here ${WORK}/here/*)
if(NOT here STREQUAL "part.pcd")
  message(SEND_ERROR "beside the scan there is now ${here}")
endif()

# 3: refused: the finishing leaves more than may be left
run(3 "verification.*residual.*refused.png" mill ${DATA}/dome.pcd -o refused
    --finish-allowance 0.3 --residual-limit 0.05)
file(GLOB written RELATIVE ${WORK}/refused ${WORK}/refused/*)
if(NOT written STREQUAL "refused.html;refused.json;refused.png")
  message(SEND_ERROR "a refused job wrote ${written}")
endif()

# 0: good, with a directory that is there already, and by its default name
file(MAKE_DIRECTORY ${WORK}/good)
file(WRITE ${WORK}/good/notes.txt "mine")
run(0 "verified" mill ${DATA}/dome.pcd -o good)
foreach(name program.ngc part.pcd cl.pcd preview.png report.json notes.txt)
  if(NOT EXISTS ${WORK}/good/${name})
    message(SEND_ERROR "good/${name} is missing")
  endif()
endforeach()
run(0 "^$" mill ${DATA}/dome.pcd --quiet)

file(WRITE ${WORK}/drill.ngc "G21 G81 X1 Y1 Z-3 R1 F100\n")
# check: the same program, one that is wrong, one that is none, and no job
run(0 "passed\n$" check good/program.ngc --dir good --picture good/findings.png
    --deviation good/deviation.pcd --milled good/milled.stl --report good/check.html)
foreach(name findings.png deviation.pcd milled.stl check.html)
  if(NOT EXISTS ${WORK}/good/${name})
    message(SEND_ERROR "good/${name} is missing")
  endif()
endforeach()
run(0 "^$" check good/program.ngc --dir good --quiet)
file(READ ${WORK}/good/program.ngc program)
string(REPLACE "T3 M6\nG43 H3" "T1 M6\nG43 H1" wrong "${program}")
file(WRITE ${WORK}/wrong.ngc "${wrong}")
execute_process(
  COMMAND ${PROGRAM} check wrong.ngc --dir good
  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE output)
if(NOT status EQUAL 3 OR NOT output MATCHES "error gouge: .*line [0-9]+.*refused\n$")
  message(SEND_ERROR "a wrong tool: exit code ${status}, ${output}")
endif()
execute_process(
  COMMAND ${PROGRAM} check drill.ngc --dir good
  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE output)
if(NOT status EQUAL 3 OR NOT output MATCHES "drill.ngc: line 1, column 5: G81.*refused\n$")
  message(SEND_ERROR "a drilling cycle: exit code ${status}, ${output}")
endif()
run(1 "--corners" check good/program.ngc --dir good --corners round)
run(2 "missing.ngc" check missing.ngc --dir good)
run(2 "nowhere.*report.json" check good/program.ngc --dir nowhere)
run(1 "--dir" check good/program.ngc)
run(1 "nearest|did you mean" check good/program.ngc --dir good --post hass)

# speeds and feeds of a material
run(0 "passed|verified" mill ${DATA}/dome.pcd -o wood --material beech --max-spindle 18000
    --finish-feed 900)
file(READ ${WORK}/wood/report.json report)
if(NOT report MATCHES "\"spindle_rpm\": 18000.0" OR NOT report MATCHES "\"feed_mm_min\": 900.0")
  message(SEND_ERROR "wood/report.json: speeds and feeds are not those of the material")
endif()

# posts
run(0 "program_1_T1.nc.*program_3_T3.nc" mill ${DATA}/dome.pcd -o grbl --post grbl)
run(1 "post.*linuxcnc" mill ${DATA}/dome.pcd -o out --post lathe)
file(WRITE ${WORK}/mine.yaml "base: haas\nextension: tap\n")
run(0 "program.tap" mill ${DATA}/dome.pcd -o mine --post ./mine.yaml)
file(WRITE ${WORK}/bad.yaml "base: haas\nextention: tap\n")
run(2 "bad.yaml:2: unknown key .extention." mill ${DATA}/dome.pcd -o out --post ./bad.yaml)
run(0 "T2 bull 4 mm corner 1 mm .*T3 taper ball 2 mm, 5 deg, to 4 mm .*verified"
    mill ${DATA}/dome.pcd -o cutters --semi-corner 1 --semi-diameter 4 --semi-type bull
    --finish-diameter 4 --finish-tip 2 --finish-taper 5 --finish-type taper)
file(READ ${WORK}/cutters/report.json report)
foreach(tool "\"type\": \"bull\"" "\"taper_deg\": 5.0" "\"tip_diameter\": 2.0")
  if(NOT report MATCHES "${tool}")
    message(SEND_ERROR "cutters/report.json lacks ${tool}")
  endif()
endforeach()
file(SHA256 ${WORK}/good/program.ngc first)
file(SHA256 ${WORK}/dome_nc/program.ngc second)
if(NOT first STREQUAL second)
  message(SEND_ERROR "two runs gave two programs")
endif()
file(REMOVE_RECURSE ${WORK})
