// How the trees want the robot to look, on /expression (coppice_msgs/Expression), said on change
// and every second. coppice-face shows it.
#ifndef COPPICE_ROBOT_APP_ROS_ROS_FACE_H_
#define COPPICE_ROBOT_APP_ROS_ROS_FACE_H_

#include <ros/node_handle.h>

#include <array>
#include <mutex>

#include "bt_nodes/interaction/expression.h"

namespace coppice::robot::adapters {

class RosFace : public leaves::Face {
 public:
  explicit RosFace(ros::NodeHandle& node);

  void SetExpression(leaves::Expression expression) override;
  void Hold(leaves::Expression expression) override;
  void Release(leaves::Expression expression) override;

 private:
  void Publish() const;
  void Change(leaves::Expression expression, int by);

  mutable std::mutex mutex_;
  leaves::Expression lasting_ = leaves::Expression::NEUTRAL;
  std::array<int, leaves::kExpressionCount> holders_{};
  ros::Publisher publisher_;
  ros::WallTimer again_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ROS_FACE_H_
