# How everything is compiled: C++17, strict warnings, optional sanitizers, ccache and mold when present.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(THREADS_PREFER_PTHREAD_FLAG ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Build type" FORCE)
endif()
# Line tables are enough for stack traces; full debug information doubles the build.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")
# A test runs once for each time that it is compiled: what it tests is optimized, it is not.
set(COPPICE_TEST_OPTIONS -O0)

add_library(coppice_warnings INTERFACE)
target_compile_options(coppice_warnings INTERFACE -Wall -Wextra)
if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)  # others compile with options that nobody here has seen
  target_compile_options(coppice_warnings INTERFACE -Werror)
endif()

if(COPPICE_SANITIZE)
  set(COPPICE_SANITIZER_OPTIONS ${PROJECT_SOURCE_DIR}/tests/support/sanitizer_options.cc)
  add_compile_options(-fsanitize=${COPPICE_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${COPPICE_SANITIZE})
  if(NOT COPPICE_SANITIZE MATCHES fuzzer)
    add_compile_options(-O1)  # compiles in two thirds of the time
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # is wrong about <regex> when it sanitizes
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
endif()
# ThreadSanitizer cannot follow bare memory fences; Boost.Asio does without where there are locks.
if(COPPICE_SANITIZE MATCHES thread)
  add_compile_definitions(BOOST_ASIO_DISABLE_FENCED_BLOCK)
endif()

find_program(COPPICE_CCACHE ccache)
if(COPPICE_CCACHE)
  # Else it refuses all that has a precompiled header, which here is everything; and what a source
  # includes is told by the compiler, for which ccache would read it all once more.
  set(CMAKE_CXX_COMPILER_LAUNCHER /usr/bin/env CCACHE_SLOPPINESS=pch_defines,time_macros
                                  CCACHE_DEPEND=1 ${COPPICE_CCACHE})
endif()
find_program(COPPICE_MOLD mold)
if(COPPICE_MOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND
   CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12.1)
  add_link_options(-fuse-ld=mold)
endif()
