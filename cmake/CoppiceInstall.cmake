# `cmake --install build --prefix PREFIX`: the engine's libraries, headers and command line, and what
# find_package(coppice) needs, the editor, its page. The robot is run from the build folder.
#   find_package(coppice 0.1 REQUIRED)
#   target_link_libraries(my_robot coppice::bt_core coppice::record coppice::live)
# coppice-config.cmake.in lists the targets; CoppicePackage.cmake packs the components.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(COPPICE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/coppice)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME engine)

set(libraries bt_core bt_core_frames bt_core_record bt_core_analysis bt_core_scenario)
if(COPPICE_LIVE)
  list(APPEND libraries bt_core_condition bt_core_debugger bt_core_live bt_core_live_client)
endif()
foreach(library ${libraries})
  string(REPLACE bt_core_ "" name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS ${libraries} EXPORT coppice ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS coppice RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/coppice RENAME copyright)
install(EXPORT coppice NAMESPACE coppice:: FILE coppice-targets.cmake
        DESTINATION ${COPPICE_PACKAGE_DIR})

# Node types of other programs, for other tools; ours have them built in.
install(DIRECTORY bt_core/engine/models/ DESTINATION ${CMAKE_INSTALL_DATADIR}/coppice/models
        FILES_MATCHING PATTERN "*.xml")

# The editor's programs, which `coppice` finds beside itself, and what it offers to a newcomer.
# Whoever has built the engine alone installs that.
if(TARGET coppice-edit)
  install(TARGETS coppice-edit coppice-diff coppice-export
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT editor OPTIONAL)
  install(DIRECTORY editor/examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/coppice/examples
          COMPONENT editor)
endif()

# The page lies where the installed program looks for it.
if(COPPICE_WEB)
  install(DIRECTORY ${COPPICE_WEB_FOLDER}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/coppice/web COMPONENT web
          FILES_MATCHING PATTERN "index.*")
endif()

set(other_headers PATTERN cli EXCLUDE)
if(NOT COPPICE_LIVE)
  list(APPEND other_headers PATTERN live EXCLUDE)
endif()
install(DIRECTORY bt_core DESTINATION include/coppice
        FILES_MATCHING PATTERN "*.h" ${other_headers})

configure_package_config_file(cmake/coppice-config.cmake.in
  ${PROJECT_BINARY_DIR}/coppice-config.cmake INSTALL_DESTINATION ${COPPICE_PACKAGE_DIR})
# 0.x: what comes new may change what there was.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/coppice-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/coppice-config.cmake
              ${PROJECT_BINARY_DIR}/coppice-config-version.cmake
              cmake/CoppiceDependencies.cmake cmake/CoppicePlugin.cmake
        DESTINATION ${COPPICE_PACKAGE_DIR})
