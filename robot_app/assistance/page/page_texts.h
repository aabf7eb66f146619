// ROS messages as the JSON texts and bytes that the supervisor page understands.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_TEXTS_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_TEXTS_H_

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>
#include <nav_msgs/OccupancyGrid.h>

#include <optional>
#include <string>
#include <vector>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::assistance {

/// {"type": "health", "entries": [...]}, the worst first.
std::string HealthText(const coppice_msgs::Health& health);

/// {"type": "processes", "configuration", "groups": [{"name", "state", "processes": [...]}]}.
std::string ProcessesText(const coppice_msgs::ProcessStates& states);

/// {"type": "place", "pose": [x, y, yaw] or null, "scan": [x, y, ...]}; the scan in base_link, at
/// most 200 points of it.
std::string PlaceText(const std::optional<Pose2D>& pose, const std::vector<Point2D>& scan);

/// {"type": "trees", "trees": [{"name", "live", "path": [...]}]}.
struct TreeText {
  std::string name;
  bool is_live = false;
  std::vector<std::string> path;
};
std::string TreesText(const std::vector<TreeText>& trees);

/// Byte 2 and three zeros; width and height (int32), resolution [m], x, y and yaw of the corner
/// (float32), all little-endian; then the cells as in the message. Nothing if the message
/// contradicts itself.
std::optional<std::string> MapBytes(const nav_msgs::OccupancyGrid& map);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_TEXTS_H_
