#include "robot_app/common/transforms/transforms.h"

#include <ros/console.h>

namespace coppice::robot {
namespace {

constexpr int kQueue = 100;

}  // namespace

Transforms::Transforms(ros::NodeHandle node) : node_(std::move(node)) {
  const auto subscribe = [this](const char* topic, bool is_static) {
    ros::SubscribeOptions options = ros::SubscribeOptions::create<tf2_msgs::TFMessage>(
        topic, kQueue,
        [this, topic, is_static](const tf2_msgs::TFMessage::ConstPtr& message) {
          const std::size_t refused = memory_.Store(*message, is_static, ros::Time::now());
          if (refused == 0) return;
          ROS_WARN_THROTTLE(10, "%s names too many frames, or too long ones; %zu are not used",
                            topic, refused);
        },
        nullptr, &at_once_);
    return node_.subscribe(options);
  };
  moving_ = subscribe("/tf", false);
  fixed_ = subscribe("/tf_static", true);
}

}  // namespace coppice::robot
