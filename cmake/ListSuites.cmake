# Writes the tests of ctest of one GoogleTest program: one for each suite or, if EACH is true, for
# each case; each is a process of its own. Called after the program has been built; PROGRAM, NAME,
# PROPERTIES, EACH and FILE are given with -D.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests
  OUTPUT_VARIABLE listing RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${result}")
endif()
string(REPLACE ";" "," listing "${listing}")  # in the values of parameters
string(REPLACE "\n" ";" lines "${listing}")
string(REPLACE "," " " properties "${PROPERTIES}")

set(tests "")
function(add name filter)
  set(tests "${tests}add_test([=[${NAME}.${name}]=] \"${PROGRAM}\" \"--gtest_filter=${filter}\")
set_tests_properties([=[${NAME}.${name}]=] PROPERTIES ${properties})\n" PARENT_SCOPE)
endfunction()

foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_/]+)[.]")
    set(suite ${CMAKE_MATCH_1})
    if(NOT EACH)
      add(${suite} ${suite}.*)
    endif()
  elseif(EACH AND line MATCHES "^  ([A-Za-z0-9_/]+)")
    add(${suite}.${CMAKE_MATCH_1} ${suite}.${CMAKE_MATCH_1})
  endif()
endforeach()
file(WRITE ${FILE} "${tests}")
