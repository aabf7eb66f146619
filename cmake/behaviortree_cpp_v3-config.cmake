# The interface of BehaviorTree.CPP 3, by Coppice: #include "behaviortree_cpp_v3/..."
#   find_package(behaviortree_cpp_v3 REQUIRED)
#   target_link_libraries(my_robot BT::behaviortree_cpp_v3)
include(CMakeFindDependencyMacro)
find_dependency(behaviortree_cpp)
if(NOT TARGET BT::behaviortree_cpp_v3)
  add_library(BT::behaviortree_cpp_v3 INTERFACE IMPORTED)
  set_target_properties(BT::behaviortree_cpp_v3 PROPERTIES
    INTERFACE_LINK_LIBRARIES BT::behaviortree_cpp
    INTERFACE_COMPILE_DEFINITIONS USE_BTCPP3_OLD_NAMES)
endif()
set(behaviortree_cpp_v3_TARGETS BT::behaviortree_cpp_v3)
set(behaviortree_cpp_v3_LIBRARIES BT::behaviortree_cpp_v3)
