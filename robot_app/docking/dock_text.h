// Numbers in sentences for people.
#ifndef COPPICE_ROBOT_APP_DOCKING_DOCK_TEXT_H_
#define COPPICE_ROBOT_APP_DOCKING_DOCK_TEXT_H_

#include <cstdio>
#include <string>

namespace coppice::robot::docking {

inline std::string Print(const char* format, double value, int a = 0) {
  char text[160];
  std::snprintf(text, sizeof text, format, value, a);
  return text;
}

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_DOCK_TEXT_H_
