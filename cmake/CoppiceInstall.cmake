# `cmake --install build --prefix PREFIX`: the engine's libraries, headers and command line, and what
# find_package(coppice) needs, the editor, its page, the robot.
#   find_package(coppice 0.1 REQUIRED)
#   target_link_libraries(my_robot coppice::bt_core coppice::record coppice::live)
# coppice-config.cmake.in lists the targets; CoppicePackage.cmake packs the components.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(COPPICE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/coppice)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME engine)
set(COPPICE_MAINTAINER "The Coppice authors <authors@coppice.invalid>")

set(libraries bt_core bt_core_frames bt_core_record bt_core_analysis bt_core_scenario)
if(COPPICE_LIVE)
  list(APPEND libraries bt_core_condition bt_core_debugger bt_core_live bt_core_live_client)
endif()
foreach(library ${libraries})
  string(REPLACE bt_core_ "" name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
  add_library(coppice::${name} ALIAS ${library})  # the same name for who adds the sources to theirs
endforeach()
install(TARGETS ${libraries} EXPORT coppice
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(TARGETS coppice RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT coppice NAMESPACE coppice:: FILE coppice-targets.cmake
        DESTINATION ${COPPICE_PACKAGE_DIR} COMPONENT development)

# The interface of BehaviorTree.CPP, under its names: who has both of them says which by its prefix.
install(TARGETS behaviortree_cpp EXPORT behaviortree_cpp
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT btcpp OPTIONAL)
install(EXPORT behaviortree_cpp NAMESPACE BT:: FILE behaviortree_cpp-targets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/behaviortree_cpp COMPONENT btcpp)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/behaviortree_cpp-config-version.cmake
                                 VERSION 4.10.0 COMPATIBILITY SameMajorVersion)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/behaviortree_cpp_v3-config-version.cmake
                                 VERSION 3.8.7 COMPATIBILITY SameMajorVersion)
foreach(package behaviortree_cpp behaviortree_cpp_v3)
  install(FILES cmake/${package}-config.cmake
                ${PROJECT_BINARY_DIR}/${package}-config-version.cmake
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/${package} COMPONENT btcpp)
endforeach()
install(DIRECTORY bt_core/compat/include/ DESTINATION include/coppice/btcpp COMPONENT btcpp)

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
  install(FILES cmake/package/coppice-edit.desktop
          DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT editor)
  install(FILES cmake/package/coppice-mime.xml RENAME coppice.xml
          DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT editor)
  install(FILES cmake/package/coppice.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT editor)
endif()

# coppice_install_made(COMPONENT SCRIPT ARGUMENTS...): what a script of cmake/package makes in the
# folder of data, which is its first argument, when the component is installed.
function(coppice_install_made component script)
  string(REPLACE ";" "\" \"" arguments "${ARGN}")
  install(CODE "execute_process(COMMAND ${PROJECT_SOURCE_DIR}/cmake/package/${script}
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\" \"${arguments}\"
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR \"${script}: \${result}\")
  endif()" COMPONENT ${component})
endfunction()

# Who may copy it, and what has changed.
function(coppice_install_papers component package)
  coppice_install_made(${component} papers.sh ${package} ${COPPICE_MAINTAINER})
endfunction()
coppice_install_papers(engine coppice)
coppice_install_papers(development libcoppice-dev)
coppice_install_papers(btcpp coppice-btcpp-compat)
if(TARGET coppice-edit)
  coppice_install_papers(editor coppice-editor)
endif()
if(COPPICE_WEB)
  coppice_install_papers(web coppice-web)
endif()

# The module for Python, where Debian's Python looks.
if(TARGET coppice_python)
  set(dist_packages lib/python3/dist-packages/coppice)
  install(TARGETS coppice_python LIBRARY DESTINATION ${dist_packages} COMPONENT python OPTIONAL)
  install(DIRECTORY bt_core/python/coppice/ DESTINATION ${dist_packages} COMPONENT python
          FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN __pycache__ EXCLUDE)
  install(DIRECTORY ${COPPICE_PYTHON_INFO} DESTINATION lib/python3/dist-packages COMPONENT python)
  coppice_install_papers(python python3-coppice)
endif()

# What the programs tell of themselves: pages for `man`, words for the shell.
find_program(HELP2MAN help2man)  # who only builds does not need it
mark_as_advanced(HELP2MAN)
if(HELP2MAN)
  coppice_install_made(engine told.sh ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} coppice)
  if(TARGET coppice-edit)
    coppice_install_made(editor told.sh ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} edit diff export)
  endif()
endif()

if(COPPICE_ROBOT)
  include(CoppiceInstallRobot)
endif()

# The page lies where the installed program looks for it.
if(COPPICE_WEB)
  install(DIRECTORY ${COPPICE_WEB_FOLDER}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/coppice/web COMPONENT web
          FILES_MATCHING PATTERN "index.*")
endif()

set(other_headers PATTERN cli EXCLUDE PATTERN compat EXCLUDE)
if(NOT COPPICE_LIVE)
  list(APPEND other_headers PATTERN live EXCLUDE)
endif()
install(DIRECTORY bt_core DESTINATION include/coppice COMPONENT development
        FILES_MATCHING PATTERN "*.h" ${other_headers})

configure_package_config_file(cmake/coppice-config.cmake.in
  ${PROJECT_BINARY_DIR}/coppice-config.cmake INSTALL_DESTINATION ${COPPICE_PACKAGE_DIR})
# 0.x: what comes new may change what there was.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/coppice-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/coppice-config.cmake
              ${PROJECT_BINARY_DIR}/coppice-config-version.cmake
              cmake/CoppiceDependencies.cmake cmake/CoppicePlugin.cmake
        DESTINATION ${COPPICE_PACKAGE_DIR} COMPONENT development)
