# `./dev package`, or `cpack` in a build folder: Debian packages, so that nobody has to compile.
#   coppice         the command line, its manual pages and completion, the models of other programs
#   libcoppice-dev  libraries and headers, and what find_package(coppice) needs
#   coppice-btcpp-compat  BehaviorTree.CPP's headers, library and CMake package, by Coppice
#   python3-coppice  import coppice
#   coppice-editor  the editor, `coppice diff` and `coppice export`, the example; its icon, and that
#                   it opens records and trees
#   coppice-web     the editor as a page, for `coppice run --web` (with -DCOPPICE_WEB=ON)
#   coppice-robot   all programs of the robot, its trees and configurations, the unit for systemd
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # packs what is built: no test, no robot
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "${COPPICE_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Behaviour trees for robots")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL engine development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_ENGINE_PACKAGE_NAME coppice)
set(CPACK_COMPONENT_ENGINE_DESCRIPTION "Runs, checks, tests, records and replays behaviour trees.")
set(CPACK_DEBIAN_ENGINE_PACKAGE_RECOMMENDS coppice-web)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcoppice-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Libraries and headers to build robots with.")
# Who compiles against it needs what CoppiceDependencies.cmake looks for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libtinyxml2-dev, libzstd-dev, libsodium-dev, libboost-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "coppice (= ${PROJECT_VERSION})")

list(APPEND CPACK_COMPONENTS_ALL btcpp)
set(CPACK_DEBIAN_BTCPP_PACKAGE_NAME coppice-btcpp-compat)
set(CPACK_DEBIAN_BTCPP_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_BTCPP_DESCRIPTION "BehaviorTree.CPP's interface for C++, on Coppice's engine.")
set(CPACK_DEBIAN_BTCPP_PACKAGE_DEPENDS "libcoppice-dev (= ${PROJECT_VERSION}), nlohmann-json3-dev")
set(CPACK_DEBIAN_BTCPP_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/package/btcpp/triggers)
set(CPACK_DEBIAN_BTCPP_PACKAGE_CONFLICTS "libbehaviortree-cpp-dev, ros-noetic-behaviortree-cpp")

if(TARGET coppice_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-coppice)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Trees, leaves, tests and records in Python.")
  # The module is made for one version of Python.
  math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_python})")
  set(scripts ${CMAKE_CURRENT_LIST_DIR}/package/python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${scripts}/postinst ${scripts}/prerm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "coppice-editor, python3-pandas, python3-pytest")
endif()

if(TARGET coppice-edit)
  list(APPEND CPACK_COMPONENTS_ALL editor)
  set(CPACK_DEBIAN_EDITOR_PACKAGE_NAME coppice-editor)
  set(CPACK_COMPONENT_EDITOR_DESCRIPTION "Edits trees, and shows them live and in replay.")
  set(CPACK_DEBIAN_EDITOR_PACKAGE_DEPENDS
      "coppice (= ${PROJECT_VERSION}), fonts-dejavu-core, fonts-font-awesome")
  set(CPACK_DEBIAN_EDITOR_PACKAGE_RECOMMENDS "fonts-wqy-microhei | fonts-noto-cjk")
endif()

if(COPPICE_ROBOT)
  list(APPEND CPACK_COMPONENTS_ALL robot)
  set(CPACK_DEBIAN_ROBOT_PACKAGE_NAME coppice-robot)
  set(CPACK_DEBIAN_ROBOT_PACKAGE_SECTION science)
  set(CPACK_COMPONENT_ROBOT_DESCRIPTION
      "A service robot that repairs itself: its programs, trees, simulation and supervision.")
  # What its programs start or read, and no linker knows.
  set(CPACK_DEBIAN_ROBOT_PACKAGE_DEPENDS
      "coppice (= ${PROJECT_VERSION}), adduser, python3-rosmaster, espeak-ng-data, pocketsphinx-en-us, libjs-three, opencv-data, tzdata")
  set(CPACK_DEBIAN_ROBOT_PACKAGE_SUGGESTS "coppice-editor, chrony, postgresql, prometheus")
  set(scripts ${CMAKE_CURRENT_LIST_DIR}/package/robot)
  set(CPACK_DEBIAN_ROBOT_PACKAGE_CONTROL_EXTRA ${scripts}/postinst ${scripts}/prerm
    ${scripts}/postrm)
endif()

if(COPPICE_WEB)
  list(APPEND CPACK_COMPONENTS_ALL web)
  set(CPACK_DEBIAN_WEB_PACKAGE_NAME coppice-web)
  set(CPACK_COMPONENT_WEB_DESCRIPTION "The editor as a page that a running tree serves (coppice run --web).")
  set(CPACK_DEBIAN_WEB_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_WEB_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_WEB_PACKAGE_DEPENDS "coppice (>= ${PROJECT_VERSION})")
endif()
include(CPack)
