// The version of Coppice, for programs and plugins. CMake reads it from here.
#ifndef COPPICE_BT_CORE_BASE_VERSION_H_
#define COPPICE_BT_CORE_BASE_VERSION_H_

namespace coppice {

inline constexpr char kVersion[] = "0.1.0";

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_VERSION_H_
