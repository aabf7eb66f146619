#include "robot_app/monitoring/tf_tree.h"

#include <tf2/exceptions.h>

#include "robot_app/monitoring/aggregator/health_messages.h"

namespace coppice::robot::monitoring {
namespace {

constexpr int kQueue = 100;

}  // namespace

TfTree::TfTree(ros::NodeHandle& node) {
  const auto subscribe = [this, &node](const char* topic, bool is_static) {
    ros::SubscribeOptions options = ros::SubscribeOptions::create<tf2_msgs::TFMessage>(
        topic, kQueue,
        [this, is_static](const tf2_msgs::TFMessage::ConstPtr& message) {
          OnTransforms(*message, is_static);
        },
        nullptr, &at_once_);
    return node.subscribe(options);
  };
  moving_ = subscribe("/tf", false);
  fixed_ = subscribe("/tf_static", true);
}

void TfTree::OnTransforms(const tf2_msgs::TFMessage& message, bool is_static) {
  for (const auto& transform : message.transforms) {
    // Whatever is wrong with it is refused by the buffer and then missed by the lookup.
    buffer_.setTransform(transform, "tf", is_static);
  }
}

Expected<TransformSample> TfTree::Look(const std::string& parent, const std::string& child) const {
  try {
    const auto transform = buffer_.lookupTransform(parent, child, ros::Time());
    TransformSample sample;
    sample.stamp = FromRos(transform.header.stamp);
    sample.x = transform.transform.translation.x;
    sample.y = transform.transform.translation.y;
    sample.z = transform.transform.translation.z;
    buffer_._getParent(child, ros::Time(), sample.hangs_on);
    return sample;
  } catch (const tf2::TransformException& problem) {
    return Problem{problem.what()};
  }
}

}  // namespace coppice::robot::monitoring
