// Where ROS packages lie, found without ROS: for <include ros_pkg="..." path="..."/>.
#ifndef COPPICE_BT_CORE_MODEL_ROS_PACKAGES_H_
#define COPPICE_BT_CORE_MODEL_ROS_PACKAGES_H_

#include <string>

namespace coppice {

/// The folder of a ROS package, or empty if there is none. Looks for the package.xml of that name
/// below the folders of ROS_PACKAGE_PATH (ROS 1, first match wins, no package inside of another),
/// then for share/PACKAGE below the folders of AMENT_PREFIX_PATH (ROS 2), and at last asks the
/// program `rospack` if there is one. Reads the disk on every call.
std::string FindRosPackage(const std::string& package);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_ROS_PACKAGES_H_
