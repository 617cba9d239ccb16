# pointmill_embed(MODULE NAMESPACE {NAME FILE} ...)
#   Builds text files into a module: pointmill::NAMESPACE::NAME is a std::string_view of
#   each. A change of a file builds it anew.
function(pointmill_embed module namespace)
  while(ARGN)
    list(POP_FRONT ARGN name file)
    get_filename_component(file ${file} ABSOLUTE)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${namespace}_${name}.cpp)
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DNAMESPACE=${namespace} -DNAME=${name} -DFILE=${file}
              -DSOURCE=${source} -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
      DEPENDS ${file} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
      COMMENT "Embedding ${name}"
      VERBATIM)
    target_sources(pointmill_${module} PRIVATE ${source})
  endwhile()
endfunction()
