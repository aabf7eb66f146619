#include "robot_app/ros/ros_face.h"

#include <coppice_msgs/Expression.h>

namespace coppice::robot::adapters {

using leaves::Expression;

RosFace::RosFace(ros::NodeHandle& node)
    : publisher_(node.advertise<coppice_msgs::Expression>("/expression", 10, true)),
      again_(node.createWallTimer(ros::WallDuration(1), [this](const ros::WallTimerEvent&) {
        const std::lock_guard lock(mutex_);
        Publish();
      })) {}

void RosFace::SetExpression(Expression expression) {
  const std::lock_guard lock(mutex_);
  lasting_ = expression;
  Publish();
}

void RosFace::Hold(Expression expression) { Change(expression, 1); }
void RosFace::Release(Expression expression) { Change(expression, -1); }

void RosFace::Change(Expression expression, int by) {
  const std::lock_guard lock(mutex_);
  holders_[static_cast<std::size_t>(expression)] += by;
  Publish();
}

void RosFace::Publish() const {
  std::size_t shown = holders_.size() - 1;
  while (shown > static_cast<std::size_t>(lasting_) && holders_[shown] == 0) --shown;
  coppice_msgs::Expression message;
  message.owner = "trees";
  message.expression = ValueTraits<Expression>::Print(static_cast<Expression>(shown));
  publisher_.publish(message);
}

}  // namespace coppice::robot::adapters
