// Names of types for people.
#ifndef DEMANGLE_UTIL_H
#define DEMANGLE_UTIL_H

#include <string>
#include <typeindex>
#include <typeinfo>

namespace BT {

/// "std::string", "std::vector<double>", "Pose2D".
std::string demangle(const std::type_index& index);
std::string demangle(const std::type_info& info);

}  // namespace BT

#endif  // DEMANGLE_UTIL_H
