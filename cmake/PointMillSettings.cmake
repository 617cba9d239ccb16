# Compiler, dependencies and the shared precompiled header.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${CCACHE_PROGRAM})
endif()

find_package(Threads REQUIRED)
find_package(PCL 1.13 REQUIRED
             COMPONENTS common kdtree search sample_consensus filters io visualization)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(yaml-cpp REQUIRED)

# Flags that every target shares. -ffp-contract=off: the same bits on every machine.
add_library(pointmill_settings INTERFACE)
add_library(pointmill::settings ALIAS pointmill_settings)
target_compile_features(pointmill_settings INTERFACE cxx_std_17)
target_compile_options(pointmill_settings INTERFACE
  -Wall -Wextra -Wshadow -Wnon-virtual-dtor -ffp-contract=off
  $<$<BOOL:${POINTMILL_WERROR}>:-Werror>)
target_include_directories(pointmill_settings SYSTEM INTERFACE ${PCL_INCLUDE_DIRS})
target_link_libraries(pointmill_settings INTERFACE Threads::Threads)

if(POINTMILL_PCH)
  file(WRITE ${CMAKE_BINARY_DIR}/pch.cpp "")
  add_library(pointmill_pch OBJECT ${CMAKE_BINARY_DIR}/pch.cpp)
  target_link_libraries(pointmill_pch PRIVATE pointmill::settings)
  target_compile_options(pointmill_pch PRIVATE -fpch-preprocess)
  target_precompile_headers(pointmill_pch PRIVATE
    <algorithm> <cmath> <functional> <memory> <string> <vector>
    <Eigen/Core> <Eigen/Geometry>
    <pcl/filters/filter.h> <pcl/point_cloud.h> <pcl/point_types.h>)
endif()
