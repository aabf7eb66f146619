#include "robot_app/common/transforms/transforms.h"

namespace coppice::robot {
namespace {

constexpr int kQueue = 100;

}  // namespace

Transforms::Transforms(ros::NodeHandle node) : node_(std::move(node)) {
  const auto subscribe = [this](const char* topic, bool is_static) {
    ros::SubscribeOptions options = ros::SubscribeOptions::create<tf2_msgs::TFMessage>(
        topic, kQueue,
        [this, is_static](const tf2_msgs::TFMessage::ConstPtr& message) {
          memory_.Store(*message, is_static, ros::Time::now());
        },
        nullptr, &at_once_);
    return node_.subscribe(options);
  };
  moving_ = subscribe("/tf", false);
  fixed_ = subscribe("/tf_static", true);
}

}  // namespace coppice::robot
