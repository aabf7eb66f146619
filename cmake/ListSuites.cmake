# Writes the tests of ctest of one GoogleTest program: one for each suite, each a process of its own.
# Called after the program has been built; PROGRAM, NAME, PROPERTIES and FILE are given with -D.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests
  OUTPUT_VARIABLE listing RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${result}")
endif()
string(REPLACE ";" "," listing "${listing}")  # in the values of parameters
string(REPLACE "\n" ";" lines "${listing}")
string(REPLACE "," " " properties "${PROPERTIES}")

set(tests "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_/]+)[.]")
    set(suite ${CMAKE_MATCH_1})
    set(tests "${tests}add_test([=[${NAME}.${suite}]=] \"${PROGRAM}\" \"--gtest_filter=${suite}.*\")
set_tests_properties([=[${NAME}.${suite}]=] PROPERTIES ${properties})\n")
  endif()
endforeach()
file(WRITE ${FILE} "${tests}")
