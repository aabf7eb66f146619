// A pose in the plane, in the map frame (REP-105): x, y [m], yaw [rad] counter-clockwise from x.
#ifndef COPPICE_BT_NODES_NAVIGATION_POSE2D_H_
#define COPPICE_BT_NODES_NAVIGATION_POSE2D_H_

#include <string>
#include <string_view>

#include "bt_core/data/value.h"

namespace coppice::leaves {

struct Pose2D {
  double x = 0;
  double y = 0;
  double yaw = 0;
};

}  // namespace coppice::leaves

/// Text form: "x;y;yaw".
template <>
struct coppice::ValueTraits<coppice::leaves::Pose2D> {
  static constexpr const char* kName = "Pose2D";
  static bool Parse(std::string_view text, leaves::Pose2D& out);
  static std::string Print(const leaves::Pose2D& value);
};

#endif  // COPPICE_BT_NODES_NAVIGATION_POSE2D_H_
