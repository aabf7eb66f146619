# Writes the tests of ctest of one GoogleTest program: one for each suite, each a process of its own, or
# PROCESSES tests of many suites each, "NAME.FIRST..LAST". What a test leaves behind lies in a folder
# of its own in TEMPORARY: tests run beside each other, and two may call their files alike.
# Called after the program has been built; PROGRAM, NAME, PROPERTIES, PROCESSES (0: one for each
# suite), TEMPORARY and FILE are given with -D.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests
  OUTPUT_VARIABLE listing RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${result}")
endif()
string(REPLACE ";" "," listing "${listing}")  # in the values of parameters
string(REPLACE "\n" ";" lines "${listing}")
string(REPLACE "," " " properties "${PROPERTIES}")

set(suites "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_/]+)[.]")
    list(APPEND suites ${CMAKE_MATCH_1})
  endif()
endforeach()
list(LENGTH suites count)
set(size 1)  # suites of a test
if(PROCESSES GREATER 0)
  math(EXPR size "(${count} + ${PROCESSES} - 1) / ${PROCESSES}")
endif()

set(tests "")
foreach(first RANGE 0 ${count} ${size})
  if(first EQUAL count)
    break()
  endif()
  list(SUBLIST suites ${first} ${size} together)
  list(GET together 0 name)
  list(GET together -1 last)
  if(NOT last STREQUAL name)
    set(name ${name}..${last})
  endif()
  list(TRANSFORM together APPEND ".*")
  list(JOIN together ":" filter)
  set(temporary ${TEMPORARY}/${NAME}.${name})
  file(MAKE_DIRECTORY ${temporary})
  set(tests "${tests}add_test([=[${NAME}.${name}]=] \"${PROGRAM}\" \"--gtest_filter=${filter}\")
set_tests_properties([=[${NAME}.${name}]=] PROPERTIES ${properties}
  ENVIRONMENT [=[TEST_TMPDIR=${temporary}]=])\n")
endforeach()
file(WRITE ${FILE} "${tests}")
