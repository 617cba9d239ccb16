# Every source begins with the two SPDX lines, and a header then has #pragma once.
cmake_minimum_required(VERSION 3.22)

set(head "// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
")
foreach(folder apps bench examples modules test)
  file(GLOB_RECURSE sources ${ROOT}/${folder}/*.cpp)
  file(GLOB_RECURSE headers ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.hpp
       ${ROOT}/${folder}/*.h.in)
  foreach(source ${sources} ${headers})
    set(expected "${head}")
    if(source IN_LIST headers)
      string(APPEND expected "#pragma once\n")
    endif()
    file(READ ${source} text LIMIT 200)
    string(FIND "${text}" "${expected}" at)
    if(NOT at EQUAL 0)
      message(SEND_ERROR "${source} does not begin with\n${expected}")
    endif()
  endforeach()
endforeach()
