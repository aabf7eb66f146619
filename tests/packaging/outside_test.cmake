# Installs this build to a folder of its own, then configures, builds and runs the project
# `outside`, which knows nothing but that folder. Called with -D SOURCE, BUILD, WORK, COMPILER,
# LAUNCHER, SANITIZE, LIVE, EDITOR.
cmake_minimum_required(VERSION 3.16)

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

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

expect("SUCCESS after 3 ticks" ${WORK}/build/outside)
expect("SUCCESS after 3 recorded ticks" ${WORK}/build/outside_recorded ${WORK}/run.coppice)
expect("it sleeps: 0 differences\nit does not: 1 differences" ${WORK}/build/outside_scenario)
expect("Robot says: hello\nSUCCESS"
       ${WORK}/build/outside_btcpp ${WORK}/build/liboutside_btcpp_nodes.so)
expect("Robot says: hello\nSUCCESS" ${WORK}/build/outside_btcpp_v3)
if(LIVE)
  expect("SUCCESS after 3 watched ticks" ${WORK}/build/outside_watched)
endif()
if(EDITOR)  # found beside `coppice`, with its example
  run(${WORK}/prefix/bin/coppice edit ${WORK}/prefix/share/coppice/examples/delivery.xml
      --headless --picture ${WORK}/delivery.png)
endif()
run(${WORK}/prefix/bin/coppice run ${SOURCE}/tree.xml --plugin ${WORK}/build/outside_nodes.so)
run(${WORK}/prefix/bin/coppice replay ${WORK}/run.coppice)
