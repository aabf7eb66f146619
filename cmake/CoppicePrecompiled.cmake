# Precompiled headers: what nearly every source of a kind includes of the standard library and of
# other heavy libraries, parsed once instead of a thousand times; for tests also the few headers of
# ours that most of them include, whose templates cost more than all else.
# A source still includes all that it uses; a build with -DCOPPICE_PRECOMPILED=OFF shows whether.
#
# A folder says which kind its targets are: set(COPPICE_HEADERS engine | editor | robot).
option(COPPICE_PRECOMPILED "Parse the headers of other libraries once" ON)
set(COPPICE_HEADERS engine)

set(COPPICE_STANDARD_HEADERS
  <algorithm> <array> <atomic> <chrono> <cmath> <condition_variable> <cstdint> <cstring> <deque>
  <filesystem> <fstream> <functional> <iomanip> <iostream> <limits> <map> <memory> <mutex> <numeric>
  <optional> <random> <set> <sstream> <stdexcept> <string> <string_view> <thread> <tuple>
  <type_traits> <unordered_map> <unordered_set> <utility> <variant> <vector>)

set(COPPICE_engine_HEADERS)
set(COPPICE_engine_TEST_HEADERS bt_core/engine/executor.h bt_core/engine/program.h
                                bt_core/testing/leaf_harness.h)
set(COPPICE_editor_HEADERS <imgui.h>)
set(COPPICE_editor_TEST_HEADERS tests/editor/driver.h)
set(COPPICE_robot_HEADERS <ros/ros.h> <std_msgs/String.h> <geometry_msgs/Twist.h>
                          <sensor_msgs/LaserScan.h> <nav_msgs/OccupancyGrid.h>)
set(COPPICE_robot_TEST_HEADERS bt_core/testing/leaf_harness.h)

# coppice_precompile(TARGET library | test)   the target uses what is parsed for its kind
function(coppice_precompile target use)
  if(NOT COPPICE_PRECOMPILED OR EMSCRIPTEN)
    return()
  endif()
  set(shared coppice_${COPPICE_HEADERS}_headers_of_${use})
  if(NOT TARGET ${shared})
    set(source ${PROJECT_BINARY_DIR}/${shared}.cc)
    if(NOT EXISTS ${source})
      file(WRITE ${source} "")
    endif()
    add_library(${shared} OBJECT ${source})
    set_target_properties(${shared} PROPERTIES CXX_COMPILER_LAUNCHER
      "${PROJECT_SOURCE_DIR}/cmake/precompile_anew.sh;${CMAKE_CXX_COMPILER_LAUNCHER}")
    target_compile_features(${shared} PRIVATE cxx_std_17)
    find_package(Threads REQUIRED)
    target_link_libraries(${shared} PRIVATE Threads::Threads coppice_warnings)
    if(COPPICE_HEADERS STREQUAL editor)
      find_path(COPPICE_IMGUI_FOLDER imgui.h PATH_SUFFIXES imgui REQUIRED)
      target_include_directories(${shared} PRIVATE ${COPPICE_IMGUI_FOLDER})
    endif()
    set(headers ${COPPICE_STANDARD_HEADERS} ${COPPICE_${COPPICE_HEADERS}_HEADERS})
    if(use STREQUAL test)
      find_package(GTest CONFIG REQUIRED)
      target_link_libraries(${shared} PRIVATE GTest::gmock)
      target_compile_options(${shared} PRIVATE ${COPPICE_TEST_OPTIONS})
      target_include_directories(${shared} PRIVATE ${PROJECT_SOURCE_DIR})
      list(APPEND headers <gmock/gmock.h> <gtest/gtest.h>)
      foreach(header ${COPPICE_${COPPICE_HEADERS}_TEST_HEADERS})
        list(APPEND headers <${header}>)  # found from the root, as sources find it
      endforeach()
    else()
      set_target_properties(${shared} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    target_precompile_headers(${shared} PRIVATE ${headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${shared})
  if(COPPICE_HEADERS STREQUAL robot)
    # GCC forgets which of the parsed headers are the system's, and warns of those of Boost.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
  endif()
endfunction()
