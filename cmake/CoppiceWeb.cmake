# With -DCOPPICE_WEB=ON: the page of the editor, compiled by emscripten from the same sources in a
# build of its own (web-page). Its files go to COPPICE_WEB_FOLDER, where `coppice run --web` looks
# for them.
find_program(EMCC emcc)
if(NOT EMCC)
  message(FATAL_ERROR "emcc was not found; on Debian: apt-get install emscripten (or configure with "
                      "-DCOPPICE_WEB=OFF)")
endif()
set(toolchain /usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(COPPICE_WEB_SOURCES ${PROJECT_BINARY_DIR}/web-sources CACHE PATH
    "Unpacked Debian source packages of what the page needs; fetched if it does not exist")
# Debian's emscripten has its libraries ready in a cache that must not be replaced, and modules of
# Node.js where only Debian's own Node.js looks.
set(environment ${CMAKE_COMMAND} -E env --unset=EM_CACHE NODE_PATH=/usr/share/nodejs)
add_custom_target(coppice-web ALL
  COMMAND ${PROJECT_SOURCE_DIR}/editor/web/fetch_sources.sh ${COPPICE_WEB_SOURCES}
  COMMAND ${environment} ${CMAKE_COMMAND} -G ${CMAKE_GENERATOR}
          -S ${PROJECT_SOURCE_DIR} -B ${PROJECT_BINARY_DIR}/web-page
          -DCMAKE_TOOLCHAIN_FILE=${toolchain} -DCMAKE_BUILD_TYPE=Release
          -DCOPPICE_WEB_SOURCES=${COPPICE_WEB_SOURCES} -DCOPPICE_WEB_FOLDER=${COPPICE_WEB_FOLDER}
  COMMAND ${environment} ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR}/web-page
          --target coppice-web
  VERBATIM USES_TERMINAL)
