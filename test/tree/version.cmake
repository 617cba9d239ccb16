# The newest version of CHANGES.md is that of CMakeLists.txt.
cmake_minimum_required(VERSION 3.22)

file(STRINGS ${ROOT}/CHANGES.md headings REGEX "^## ")
list(GET headings 0 newest)
if(NOT newest MATCHES "^## ([0-9.]+)" OR NOT CMAKE_MATCH_1 STREQUAL VERSION)
  message(FATAL_ERROR "CHANGES.md begins with '${newest}', CMakeLists.txt says ${VERSION}")
endif()
