# pointmill_module(NAME SOURCES ... [USES modules ...] [PCL libraries ...] [LIBS targets ...])
#   A static library pointmill::NAME from modules/NAME. USES and PCL are what its headers
#   show; LIBS stay private.
function(pointmill_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;PCL;LIBS" ${ARGN})
  add_library(pointmill_${name} STATIC ${arg_SOURCES})
  add_library(pointmill::${name} ALIAS pointmill_${name})
  target_include_directories(pointmill_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include)
  list(TRANSFORM arg_USES PREPEND pointmill::)
  target_link_libraries(pointmill_${name}
    PUBLIC pointmill::settings ${arg_USES} ${arg_PCL} PRIVATE ${arg_LIBS})
  pointmill_use_pch(pointmill_${name})
endfunction()

# pointmill_use_pch(TARGET): the precompiled header, where it is switched on.
function(pointmill_use_pch target)
  if(POINTMILL_PCH)
    target_compile_options(${target} PRIVATE -fpch-preprocess)
    target_precompile_headers(${target} REUSE_FROM pointmill_pch)
  endif()
endfunction()

# pointmill_test(MODULE SOURCES ... [LIBS ...]): one GoogleTest program test_MODULE, each of
# its tests known to CTest.
function(pointmill_test module)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(test_${module} ${arg_SOURCES})
  target_link_libraries(test_${module}
    PRIVATE pointmill::${module} ${arg_LIBS} GTest::gtest GTest::gtest_main)
  target_include_directories(test_${module} PRIVATE ${PROJECT_SOURCE_DIR}/test/include)
  pointmill_use_pch(test_${module})
  gtest_discover_tests(test_${module} TEST_PREFIX ${module}. DISCOVERY_TIMEOUT 60)
endfunction()
