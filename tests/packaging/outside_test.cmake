# Installs this build to a folder of its own, then configures, builds and runs the project
# `outside`, which knows nothing but that folder. Called with -D SOURCE, BUILD, WORK, COMPILER,
# LAUNCHER, SANITIZE, LIVE, EDITOR.
cmake_minimum_required(VERSION 3.16)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
set(flags)
if(SANITIZE)
  set(flags -fsanitize=${SANITIZE})
endif()
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${WORK}/build)

# expect(PART COMMAND...): the command prints this.
function(expect part)
  run(${ARGN})
  string(FIND "${output}" "${part}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${ARGN} printed:\n${output}instead of \"${part}\"")
  endif()
endfunction()

expect("SUCCESS after 3 ticks" ${WORK}/build/outside)
expect("SUCCESS after 3 recorded ticks" ${WORK}/build/outside_recorded ${WORK}/run.coppice)
expect("it sleeps: 0 differences\nit does not: 1 differences" ${WORK}/build/outside_scenario)
if(LIVE)
  expect("SUCCESS after 3 watched ticks" ${WORK}/build/outside_watched)
endif()
if(EDITOR)  # found beside `coppice`, with its example
  run(${WORK}/prefix/bin/coppice edit ${WORK}/prefix/share/coppice/examples/delivery.xml
      --headless --picture ${WORK}/delivery.png)
endif()
run(${WORK}/prefix/bin/coppice run ${SOURCE}/tree.xml --plugin ${WORK}/build/outside_nodes.so)
run(${WORK}/prefix/bin/coppice replay ${WORK}/run.coppice)
