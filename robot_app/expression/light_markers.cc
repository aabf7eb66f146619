#include "robot_app/expression/light_markers.h"

#include <array>

namespace coppice::robot::expression {
namespace {

// A bar along a limb, beside its middle [m].
struct Bar {
  double outwards, along, length;
};
constexpr Bar kArm{0.05, -0.2, 0.36}, kEar{0.03, 0.06, 0.11};
constexpr double kThick = 0.015;  // m

bool Has(const JointOnRobot& limb, const char* part) {
  return limb.name.find(part) != std::string::npos;
}

}  // namespace

visualization_msgs::MarkerArray LightMarkers(const LightStep& lights,
                                             const std::vector<JointOnRobot>& limbs) {
  visualization_msgs::MarkerArray markers;
  for (const JointOnRobot& limb : limbs) {
    const bool is_ear = Has(limb, "ear");
    const Bar& bar = is_ear ? kEar : kArm;
    const Colour& colour = is_ear ? lights.ears : lights.arms;
    visualization_msgs::Marker& marker = markers.markers.emplace_back();
    marker.header.frame_id = limb.frame;
    marker.ns = "lights";
    marker.id = static_cast<int>(markers.markers.size());
    marker.type = visualization_msgs::Marker::CUBE;
    marker.frame_locked = 1;
    marker.pose.position.y = Has(limb, "left") ? bar.outwards : -bar.outwards;
    marker.pose.position.z = bar.along;
    marker.pose.orientation.w = 1;
    marker.scale.x = marker.scale.y = kThick;
    marker.scale.z = bar.length;
    marker.color.r = static_cast<float>(colour[0]) / 255;
    marker.color.g = static_cast<float>(colour[1]) / 255;
    marker.color.b = static_cast<float>(colour[2]) / 255;
    marker.color.a = 1;
  }
  return markers;
}

}  // namespace coppice::robot::expression
