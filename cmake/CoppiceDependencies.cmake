# What the engine's libraries need, for this build and for those who use an installed Coppice.
#   coppice_dependencies(LIVE bool RESULT variable)
#   Makes Threads::Threads, coppice::tinyxml2, coppice::zstd and, for the live socket,
#   PkgConfig::SODIUM. Sets the variable to what is missing, in words, or to nothing.
macro(coppice_dependencies)
  cmake_parse_arguments(COPPICE_DEPENDENCIES "" "LIVE;RESULT" "" ${ARGN})
  set(${COPPICE_DEPENDENCIES_RESULT})

  find_package(Threads)
  if(NOT Threads_FOUND)
    set(${COPPICE_DEPENDENCIES_RESULT} "threads were not found")
  endif()

  find_library(COPPICE_TINYXML2 tinyxml2)
  mark_as_advanced(COPPICE_TINYXML2)
  if(NOT COPPICE_TINYXML2)
    set(${COPPICE_DEPENDENCIES_RESULT}
        "tinyxml2 was not found; on Debian and Ubuntu: apt-get install libtinyxml2-dev")
  elseif(NOT TARGET coppice::tinyxml2)
    add_library(coppice::tinyxml2 UNKNOWN IMPORTED GLOBAL)
    set_target_properties(coppice::tinyxml2 PROPERTIES IMPORTED_LOCATION ${COPPICE_TINYXML2})
  endif()

  find_library(COPPICE_ZSTD zstd)
  mark_as_advanced(COPPICE_ZSTD)
  if(NOT COPPICE_ZSTD)
    set(${COPPICE_DEPENDENCIES_RESULT}
        "zstd was not found; on Debian and Ubuntu: apt-get install libzstd-dev")
  elseif(NOT TARGET coppice::zstd)
    add_library(coppice::zstd UNKNOWN IMPORTED GLOBAL)
    set_target_properties(coppice::zstd PROPERTIES IMPORTED_LOCATION ${COPPICE_ZSTD})
  endif()

  if(${COPPICE_DEPENDENCIES_LIVE} AND NOT TARGET PkgConfig::SODIUM)
    find_package(PkgConfig QUIET)
    if(PkgConfig_FOUND)
      pkg_check_modules(SODIUM QUIET IMPORTED_TARGET GLOBAL libsodium)
    endif()
    if(NOT TARGET PkgConfig::SODIUM)
      set(${COPPICE_DEPENDENCIES_RESULT}
          "libsodium was not found; on Debian and Ubuntu: apt-get install pkg-config libsodium-dev")
    endif()
  endif()
endmacro()
