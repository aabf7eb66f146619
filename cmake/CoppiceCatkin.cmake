# In a catkin workspace: other packages find the engine as a component of catkin, or by
# find_package(coppice), and link coppice::bt_core.
find_package(catkin REQUIRED)
catkin_package(INCLUDE_DIRS ${PROJECT_SOURCE_DIR} LIBRARIES ${libraries})
