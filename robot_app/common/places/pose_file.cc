#include "robot_app/common/places/pose_file.h"

#include <cstdio>
#include <fstream>

#include "bt_core/model/write_file.h"

namespace coppice::robot {

std::optional<Pose2D> LoadPose(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) return std::nullopt;
  return ParsePose(line);
}

Outcome SavePose(const std::string& file, const Pose2D& pose) {
  char line[128];
  std::snprintf(line, sizeof line, "%.4f %.4f %.4f\n", pose.x, pose.y, pose.yaw);
  Diagnostics diagnostics;
  if (WriteFile(file, line, diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

}  // namespace coppice::robot
