// Which file an <include path="..."/> or <include ros_pkg="..." path="..."/> names. ROS packages
// are found without ROS.
#ifndef COPPICE_BT_CORE_MODEL_INCLUDE_PATH_H_
#define COPPICE_BT_CORE_MODEL_INCLUDE_PATH_H_

#include <functional>
#include <string>

#include "bt_core/model/document.h"

namespace coppice {

/// The folder of a ROS package, or empty if there is none.
using PackageFinder = std::function<std::string(const std::string& package)>;

/// The path of an existing file: `path`, relative to the folder of the document or, with `ros_pkg`,
/// to that of the package. Empty if there is no such file; then `diagnostics` says why, at the
/// attribute that is wrong, with the nearest file name.
std::string IncludePath(const Document& document, const Element& include,
                        const PackageFinder& find_package, Diagnostics& diagnostics);

/// The folder of a ROS package, or empty if there is none. Looks for the package.xml of that name
/// below the folders of ROS_PACKAGE_PATH (ROS 1, first match wins, no package inside of another),
/// then for share/PACKAGE below the folders of AMENT_PREFIX_PATH (ROS 2), and at last asks the
/// program `rospack` if there is one. Reads the disk on every call.
std::string FindRosPackage(const std::string& package);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_INCLUDE_PATH_H_
