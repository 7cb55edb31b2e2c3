# Laws as CMake targets.  find_package(mlaw 1) includes this file; so may a project that has a copy of it.
#
#   mlaw_add_plugin(NAME SOURCES FILE... [NO_CHECK])
#
# makes NAME.so as mlaw.h asks for: one exported symbol, nothing undefined, no fast-math.  Where there is a
# capsella program, the test NAME.check runs `capsella laws check` (after enable_testing()).
if(NOT TARGET mlaw::mlaw)
  get_filename_component(mlaw_INCLUDE_DIR "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
  add_library(mlaw::mlaw INTERFACE IMPORTED)
  set_target_properties(mlaw::mlaw PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${mlaw_INCLUDE_DIR}")
  find_program(MLAW_CAPSELLA capsella HINTS "${mlaw_INCLUDE_DIR}/../bin" DOC "The program that checks laws")
endif()

function(mlaw_refuse_fast_math name)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_target_property(options ${name} COMPILE_OPTIONS)
  foreach(language C CXX)
    string(APPEND options " ${CMAKE_${language}_FLAGS} ${CMAKE_${language}_FLAGS_${type}}")
  endforeach()
  if(options MATCHES "-Ofast|-ffast-math|-funsafe-math-optimizations")
    message(FATAL_ERROR "${name}: a law must not be compiled with ${CMAKE_MATCH_0}, which changes the "
                        "floating-point mode of the program that loads it")
  endif()
endfunction()

function(mlaw_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 plugin NO_CHECK "" SOURCES)
  if(NOT plugin_SOURCES OR plugin_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "expected mlaw_add_plugin(${name} SOURCES FILE... [NO_CHECK])")
  endif()
  add_library(${name} MODULE ${plugin_SOURCES})
  target_link_libraries(${name} PRIVATE mlaw::mlaw m)
  target_compile_options(${name} PRIVATE $<$<CONFIG:>:-O2>)
  target_link_options(${name} PRIVATE -Wl,--no-undefined)
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so
    C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  foreach(standard C_STANDARD=11 CXX_STANDARD=20)
    string(REPLACE "=" ";" standard ${standard})
    list(GET standard 0 property)
    list(GET standard 1 year)
    if(NOT CMAKE_${property})
      set_target_properties(${name} PROPERTIES ${property} ${year})
    endif()
  endforeach()
  mlaw_refuse_fast_math(${name})
  if(MLAW_CAPSELLA AND NOT plugin_NO_CHECK)
    add_test(NAME ${name}.check COMMAND ${MLAW_CAPSELLA} laws check $<TARGET_FILE:${name}>)
  endif()
endfunction()
