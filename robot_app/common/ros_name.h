// Names of topics, services and nodes in configuration files: roscpp ends the program that uses a
// wrong one.
#ifndef COPPICE_ROBOT_APP_COMMON_ROS_NAME_H_
#define COPPICE_ROBOT_APP_COMMON_ROS_NAME_H_

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot {

/// "/name", with letters, digits, "_" and "/" behind the slash (wiki.ros.org/Names).
inline bool IsRosName(std::string_view name) {
  return name.size() > 1 && name.front() == '/' &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return c < 0x80 && (std::isalnum(c) || c == '_' || c == '/');
         });
}

/// An error of the field `key` if its text is no such name.
inline void ExpectRosName(const YamlFields& fields, const std::string& key,
                          const LocatedText& name) {
  if (IsRosName(name.text)) return;
  fields.Error(name.where,
               "\"" + key + "\": expected a ROS name with slash, got \"" + name.text + "\"",
               "letters, digits, _ and / behind it");
}

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_ROS_NAME_H_
