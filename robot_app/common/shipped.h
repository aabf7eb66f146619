// Files that come with the robot: trees, configurations, floors, pages, what its classifiers have
// learnt. An installed program finds them beside itself; one in a build folder, where they were
// when it was built.
//
//   RobotDescription::Load(Shipped(COPPICE_ROBOT));   // a path in the sources or the build folder
#ifndef COPPICE_ROBOT_APP_COMMON_SHIPPED_H_
#define COPPICE_ROBOT_APP_COMMON_SHIPPED_H_

#include <string>

namespace coppice::robot {

/// Where the file or folder lies that was built from `built`, an absolute path in the sources or
/// the build folder. Of an installed program it is ../share/coppice/robot and the rest of the path;
/// a path that is in neither of them stays what it is.
std::string Shipped(const std::string& built);

/// The same, for a program in the folder `programs`.
std::string ShippedWith(const std::string& programs, const std::string& built);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_SHIPPED_H_
