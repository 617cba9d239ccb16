# doc/report.md explains every name that a report can hold.
cmake_minimum_required(VERSION 3.22)

file(READ ${ROOT}/doc/report.md page)
file(READ ${ROOT}/modules/mill/src/report.cpp text)
string(REGEX REPLACE "[!=]= \"[a-z_]*\"" "" text "${text}") # compared with, not written
string(REGEX MATCHALL "\"[a-z][a-z_0-9]*\"" names "${text}")
list(REMOVE_DUPLICATES names)
foreach(name ${names})
  string(REPLACE "\"" "`" quoted ${name})
  string(FIND "${page}" "${quoted}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "doc/report.md does not explain ${quoted}")
  endif()
endforeach()
