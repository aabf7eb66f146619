# BehaviorTree.CPP's interface, by Coppice.
#   find_package(behaviortree_cpp 4 REQUIRED)
#   target_link_libraries(my_robot BT::behaviortree_cpp)
include(${CMAKE_CURRENT_LIST_DIR}/behaviortree_cpp-targets.cmake)
if(NOT TARGET behaviortree_cpp::behaviortree_cpp)  # the name in workspaces of ROS
  add_library(behaviortree_cpp::behaviortree_cpp INTERFACE IMPORTED)
  set_target_properties(behaviortree_cpp::behaviortree_cpp PROPERTIES
    INTERFACE_LINK_LIBRARIES BT::behaviortree_cpp)
endif()
set(behaviortree_cpp_TARGETS BT::behaviortree_cpp)
set(behaviortree_cpp_LIBRARIES BT::behaviortree_cpp)
