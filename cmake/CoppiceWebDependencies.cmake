# In place of CoppiceDependencies when the editor is compiled for browsers (CoppiceWeb.cmake): there
# are no ready libraries for them, so they are compiled from Debian's source packages, which
# editor/web/fetch_sources.sh has put into COPPICE_WEB_SOURCES. Headers without a library are those
# of the system. The targets bear the names that the other build gives them.
# coppice_web_source(NAME variable)   the folder of a package, whatever its version is
function(coppice_web_source name result)
  file(GLOB folders LIST_DIRECTORIES true ${COPPICE_WEB_SOURCES}/${name}-[0-9]*)
  list(FILTER folders EXCLUDE REGEX "\\.(dsc|xz|gz|asc)$")
  list(LENGTH folders count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "expected one folder ${name}-VERSION in ${COPPICE_WEB_SOURCES}; run "
                        "editor/web/fetch_sources.sh ${COPPICE_WEB_SOURCES}")
  endif()
  set(${result} ${folders} PARENT_SCOPE)
endfunction()

# coppice_web_library(NAME TARGET INCLUDE folder SOURCES files... [DEFINE macros...])
function(coppice_web_library name target)
  cmake_parse_arguments(ARG "" "" "INCLUDE;SOURCES;DEFINE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} SYSTEM PUBLIC ${ARG_INCLUDE})
  target_compile_definitions(${name} PUBLIC ${ARG_DEFINE})
  target_compile_options(${name} PRIVATE -w)
  add_library(${target} ALIAS ${name})
endfunction()

add_compile_options(-fexceptions)
add_link_options(-fexceptions)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG")
add_library(web_threads INTERFACE)  # there are none
add_library(Threads::Threads ALIAS web_threads)

# Of all system headers these alone: others belong to another C library.
set(headers ${PROJECT_BINARY_DIR}/system-headers)
file(MAKE_DIRECTORY ${headers})
file(CREATE_LINK /usr/include/nlohmann ${headers}/nlohmann SYMBOLIC)
file(CREATE_LINK /usr/include/stb ${headers}/stb SYMBOLIC)
include_directories(SYSTEM ${headers})
set(NLOHMANN_JSON_INCLUDE_DIR ${headers})

coppice_web_source(tinyxml2 folder)
coppice_web_library(web_tinyxml2 coppice::tinyxml2
  INCLUDE ${folder}
  SOURCES ${folder}/tinyxml2.cpp)

coppice_web_source(libzstd folder)
file(GLOB sources ${folder}/lib/common/*.c ${folder}/lib/compress/*.c ${folder}/lib/decompress/*.c)
coppice_web_library(web_zstd coppice::zstd
  INCLUDE ${folder}/lib
  SOURCES ${sources}
  DEFINE ZSTD_DISABLE_ASM)

coppice_web_source(zlib folder)
file(GLOB sources ${folder}/*.c)
coppice_web_library(web_zlib ZLIB::ZLIB
  INCLUDE ${folder}
  SOURCES ${sources}
  DEFINE HAVE_UNISTD_H)

coppice_web_source(libpng1.6 folder)
file(GLOB sources ${folder}/png*.c)
list(FILTER sources EXCLUDE REGEX "pngtest")
configure_file(${folder}/scripts/pnglibconf.h.prebuilt ${headers}/pnglibconf.h COPYONLY)
coppice_web_library(web_png PNG::PNG
  INCLUDE ${folder}
  SOURCES ${sources})
target_link_libraries(web_png PUBLIC web_zlib)

coppice_web_source(imgui folder)
coppice_web_library(web_imgui PkgConfig::IMGUI
  INCLUDE ${folder} ${folder}/misc/cpp
  SOURCES
    ${folder}/imgui.cpp
    ${folder}/imgui_draw.cpp
    ${folder}/imgui_tables.cpp
    ${folder}/imgui_widgets.cpp
    ${folder}/misc/cpp/imgui_stdlib.cpp
    ${folder}/backends/imgui_impl_opengl3.cpp
  DEFINE "ImDrawIdx=unsigned int")  # WebGL has no base vertex

# Dear ImGui keeps its own copy to itself.
set(stb ${PROJECT_BINARY_DIR}/stb_truetype.c)
file(WRITE ${stb}.in "#define STB_TRUETYPE_IMPLEMENTATION\n#include <stb/stb_truetype.h>\n")
configure_file(${stb}.in ${stb} COPYONLY)
add_library(web_stb STATIC ${stb})
target_compile_options(web_stb PRIVATE -w)
target_link_libraries(web_imgui PUBLIC web_stb)

macro(coppice_dependencies)
  cmake_parse_arguments(COPPICE_DEPENDENCIES "" "LIVE;RESULT" "" ${ARGN})
  set(${COPPICE_DEPENDENCIES_RESULT})
endmacro()
