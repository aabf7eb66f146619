# Many sources are compiled at a time, so that what they include is parsed once.
# Who works on one of them configures with -DCOPPICE_JOINED=OFF, and so does what wants to know how each
# source is compiled, as clangd and clang-tidy.
option(COPPICE_JOINED "Compile up to ten sources, or 25 of tests, at a time" ON)
find_program(COPPICE_JOINING python3 HINTS /usr/bin)
if(COPPICE_JOINED AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # It looks for garbage from 512 MB on, which takes a tenth less time.
  add_compile_options(--param=ggc-min-heapsize=524288)
endif()

# coppice_join(NAME RESULT SOURCES...)   what the target NAME compiles in place of its sources
#   joined_sources.py says which are joined. What has options of its own, which are set before, is not.
function(coppice_join name result)
  set(joined "")
  set(alone "")
  foreach(source ${ARGN})
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    get_source_file_property(definitions ${source} COMPILE_DEFINITIONS)
    get_filename_component(path ${source} ABSOLUTE)
    if(options OR definitions OR NOT EXISTS ${path})
      list(APPEND alone ${source})
    else()
      list(APPEND joined ${path})
    endif()
  endforeach()
  list(LENGTH joined count)
  if(NOT COPPICE_JOINED OR NOT COPPICE_JOINING OR count LESS 2)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  list(SORT joined)  # those of a folder include the same
  execute_process(
    COMMAND ${COPPICE_JOINING} ${PROJECT_SOURCE_DIR}/cmake/joined_sources.py ${PROJECT_SOURCE_DIR}
            ${CMAKE_CURRENT_BINARY_DIR}/${name}_joined_ ${joined}
    OUTPUT_VARIABLE compiled RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    message(FATAL_ERROR "joined_sources.py failed on the sources of ${name}")
  endif()
  string(REPLACE "\n" ";" compiled "${compiled}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # takes a source that is included for a header
    set_source_files_properties(${compiled} PROPERTIES COMPILE_OPTIONS -Wno-subobject-linkage)
  endif()
  set(${result} ${compiled} ${alone} PARENT_SCOPE)
endfunction()

# coppice_join_tests(NAME RESULT SOURCES...)   sources named *_test.cc, 25 at a time as one to compile
#   All of a test lies in an unnamed namespace: JoinSources.cmake gives it a name, and any tests can meet.
function(coppice_join_tests name result)
  set(tests ${ARGN})
  list(FILTER tests INCLUDE REGEX "_test\\.cc$")
  list(LENGTH tests count)
  if(NOT COPPICE_JOINED OR count LESS 3)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  set(compiled ${ARGN})
  list(FILTER compiled EXCLUDE REGEX "_test\\.cc$")
  list(TRANSFORM tests PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")
  math(EXPR units "(${count} + 24) / 25")
  math(EXPR size "(${count} + ${units} - 1) / ${units}")  # as equal as they can be
  foreach(unit RANGE 1 ${units})
    math(EXPR first "(${unit} - 1) * ${size}")
    list(SUBLIST tests ${first} ${size} sources)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/${name}_${unit}.cc)
    string(REPLACE ";" "," listed "${sources}")
    add_custom_command(OUTPUT ${file}
      COMMAND ${CMAKE_COMMAND} -D SOURCES=${listed} -D UNIT=${unit} -D FILE=${file}
              -D FOLDER=${PROJECT_BINARY_DIR}
              -P ${PROJECT_SOURCE_DIR}/cmake/JoinSources.cmake
      DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/JoinSources.cmake VERBATIM)
    list(APPEND compiled ${file})
  endforeach()
  set(${result} ${compiled} PARENT_SCOPE)
endfunction()
