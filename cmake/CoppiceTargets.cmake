# One library per room, one program per main, one test program per room.

# coppice_library(NAME SOURCES... [LINK libraries...])
#   A static library whose headers are included from the project root. Installed, they lie below
#   include/coppice.
function(coppice_library name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  coppice_join(${name} sources ${ARG_UNPARSED_ARGUMENTS})
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                            $<INSTALL_INTERFACE:include/coppice>)
  target_compile_features(${name} PUBLIC cxx_std_17)
  target_link_libraries(${name} PUBLIC ${ARG_LINK} PRIVATE $<BUILD_INTERFACE:coppice_warnings>)
  if(NOT EMSCRIPTEN)  # there a program has no plugins
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    coppice_precompile(${name} library)
  endif()
endfunction()

# coppice_program(NAME SOURCES... [LINK libraries...])   builds build/bin/NAME
function(coppice_program name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  coppice_join(${name} sources ${ARG_UNPARSED_ARGUMENTS})
  add_executable(${name} ${sources} ${COPPICE_SANITIZER_OPTIONS})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} coppice_warnings)
  if(NOT EMSCRIPTEN)
    target_compile_options(${name} PRIVATE -fPIC)  # as the libraries, whose headers it shares
    coppice_precompile(${name} library)
  endif()
endfunction()

# coppice_test_program(NAME SOURCES... [LINK libraries...])   builds build/tests/bin/NAME
function(coppice_test_program name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS} ${COPPICE_SANITIZER_OPTIONS})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} coppice_warnings)
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/bin)
endfunction()

# coppice_test(NAME SOURCES... [LINK libraries...] [COST seconds] [OPTIMIZED] [PROCESSES number])
#   A GoogleTest program in build/tests/bin whose suites become tests of ctest, "NAME.SUITE": to
#   start a process (a ROS master, the fonts) for each case takes longer than most cases.
#   Which case failed is said in the output; `build/tests/bin/NAME --gtest_filter=SUITE.CASE` runs it.
#   COST: of its longest suite, if that is many: those begin first, so that none is left for the end.
#   OPTIMIZED: it calculates for long itself; one such suite at a time (the lock "calculates").
#   PROCESSES: not one for each suite but so many, where a start takes longer than a whole suite.
#   tests/support/folders.h tells where data and programs are.
function(coppice_test name)
  cmake_parse_arguments(ARG "OPTIMIZED" "COST;PROCESSES" "LINK" ${ARGN})
  if(NOT ARG_PROCESSES)
    set(ARG_PROCESSES 0)
  endif()
  coppice_join_tests(${name} sources ${ARG_UNPARSED_ARGUMENTS})
  coppice_test_program(${name} ${sources}
    LINK ${ARG_LINK} test_support GTest::gmock GTest::gtest_main)
  if(NOT ARG_OPTIMIZED)
    target_compile_options(${name} PRIVATE ${COPPICE_TEST_OPTIONS})
    coppice_precompile(${name} test)
  endif()
  set(properties "")
  if(ARG_OPTIMIZED)
    list(APPEND properties RESOURCE_LOCK calculates)
    if(NOT ARG_COST)
      set(ARG_COST 10)
    endif()
  endif()
  if(ARG_COST)
    list(APPEND properties COST ${ARG_COST})
  endif()
  list(JOIN properties "," properties)
  coppice_list_suites(${name} ${ARG_PROCESSES} "${properties}")
endfunction()

# coppice_list_suites(PROGRAM PROCESSES PROPERTIES)   what ctest runs is listed when the program is built
function(coppice_list_suites name processes properties)
  set(suites ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake)
  add_custom_command(TARGET ${name} POST_BUILD BYPRODUCTS ${suites}
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${name}> -D NAME=${name}
            -D PROPERTIES=${properties} -D PROCESSES=${processes} -D FILE=${suites}
            -D TEMPORARY=${PROJECT_BINARY_DIR}/tests/temporary
            -P ${PROJECT_SOURCE_DIR}/cmake/ListSuites.cmake
    VERBATIM)
  file(WRITE ${include} "if(EXISTS \"${suites}\")\n  include(\"${suites}\")\nelse()\n"
                        "  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()
