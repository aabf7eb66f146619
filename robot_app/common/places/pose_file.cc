#include "robot_app/common/places/pose_file.h"

#include <cmath>
#include <cstdio>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot {
namespace {

constexpr std::size_t kLongest = 1000;  // bytes
constexpr double kFarthest = 1e6;       // m: no map is that large

}  // namespace

std::optional<Pose2D> LoadPose(const std::string& file) {
  const std::optional<std::string> text = ReadFile(file, kLongest);
  if (!text) return std::nullopt;
  const auto pose = ParsePose(text->substr(0, text->find('\n')));
  const bool is_near = pose && std::hypot(pose->x, pose->y) <= kFarthest;
  return is_near ? pose : std::nullopt;
}

Outcome SavePose(const std::string& file, const Pose2D& pose) {
  char line[128];
  std::snprintf(line, sizeof line, "%.4f %.4f %.4f\n", pose.x, pose.y, pose.yaw);
  Diagnostics diagnostics;
  if (WriteFile(file, line, diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

}  // namespace coppice::robot
