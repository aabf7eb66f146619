#include "robot_app/slam/graph_message.h"

#include <cstdint>

namespace coppice::robot::slam {

geometry_msgs::Pose ToPoseMessage(const Pose3& pose) {
  geometry_msgs::Pose message;
  const Eigen::Quaterniond q(pose.linear());
  message.position.x = pose.translation().x();
  message.position.y = pose.translation().y();
  message.position.z = pose.translation().z();
  message.orientation.x = q.x();
  message.orientation.y = q.y();
  message.orientation.z = q.z();
  message.orientation.w = q.w();
  return message;
}

visualization_msgs::MarkerArray MarkersOf(const SessionGraph& graph, const std::string& frame,
                                          const Pose3& at, const ros::Time& stamp) {
  visualization_msgs::MarkerArray message;
  const auto newest = static_cast<std::uint32_t>(graph.poses().size() - 1);
  for (const LinkKind kind : {LinkKind::kStep, LinkKind::kPicture, LinkKind::kCloud}) {
    visualization_msgs::Marker lines;
    lines.header.stamp = stamp;
    lines.header.frame_id = frame;
    lines.ns = "links";
    lines.id = static_cast<int>(kind);
    lines.type = visualization_msgs::Marker::LINE_LIST;
    lines.pose = ToPoseMessage(at);
    lines.scale.x = 0.03;
    lines.color.a = 1;
    lines.color.b = kind == LinkKind::kStep ? 1 : 0;
    lines.color.r = kind == LinkKind::kPicture ? 1 : 0;
    lines.color.g = kind == LinkKind::kCloud ? 1 : 0;
    for (const Link& link : graph.graph().links) {
      if (link.kind != kind || !graph.InOneMap(link.to, newest)) continue;
      lines.points.push_back(ToPoseMessage(graph.poses()[link.from]).position);
      lines.points.push_back(ToPoseMessage(graph.poses()[link.to]).position);
    }
    message.markers.push_back(lines);
  }
  return message;
}

}  // namespace coppice::robot::slam
