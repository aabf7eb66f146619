// Which file an <include> element names.
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

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_INCLUDE_PATH_H_
