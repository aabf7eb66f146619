#include "robot_app/localization/pose_file.h"

#include <cmath>
#include <cstdio>
#include <fstream>

#include "bt_core/model/write_file.h"

namespace coppice::robot::localization {

std::optional<Pose2D> ParsePose(const std::string& text) {
  Pose2D pose;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf %lf %lf %c", &pose.x, &pose.y, &pose.yaw, &rest) != 3 ||
      !std::isfinite(pose.x + pose.y + pose.yaw)) {
    return std::nullopt;
  }
  return pose;
}

std::optional<Pose2D> LoadPose(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) return std::nullopt;
  return ParsePose(line);
}

bool SavePose(const std::string& file, const Pose2D& pose, std::string& error) {
  char line[128];
  std::snprintf(line, sizeof line, "%.4f %.4f %.4f\n", pose.x, pose.y, pose.yaw);
  Diagnostics diagnostics;
  if (WriteFile(file, line, diagnostics)) return true;
  error = diagnostics.ToString();
  return false;
}

}  // namespace coppice::robot::localization
