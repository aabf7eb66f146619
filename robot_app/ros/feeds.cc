#include "robot_app/ros/feeds.h"

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>
#include <sensor_msgs/BatteryState.h>

namespace coppice::robot {
namespace {

Health FromMessage(const coppice_msgs::Health& message, Time stamp) {
  Health health;
  health.stamp = stamp;
  for (const coppice_msgs::HealthEntry& entry : message.entries) {
    health.entries.push_back({entry.monitor, entry.subject, entry.node,
                              static_cast<HealthLevel>(entry.level), entry.message});
  }
  return health;
}

}  // namespace

std::vector<ros::Subscriber> SubscribeFeeds(ros::NodeHandle& node,
                                            const std::vector<FeedKeys>& trees,
                                            const Clock& clock) {
  std::vector<ros::Subscriber> subscribers;
  subscribers.push_back(node.subscribe<sensor_msgs::BatteryState>(
      "/battery_state", 1, [trees](const sensor_msgs::BatteryState::ConstPtr& message) {
        const bool charging =
            message->power_supply_status == sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_CHARGING;
        for (const FeedKeys& keys : trees) {
          keys.battery_level.Send(message->percentage);
          keys.charging.Send(charging);
        }
      }));
  subscribers.push_back(node.subscribe<coppice_msgs::Health>(
      "/monitoring", 1, [trees, &clock](const coppice_msgs::Health::ConstPtr& message) {
        const Health health = FromMessage(*message, clock.Now());
        for (const FeedKeys& keys : trees) keys.monitoring.Send(health);
      }));
  subscribers.push_back(node.subscribe<coppice_msgs::ProcessStates>(
      "/processes", 1, [trees](const coppice_msgs::ProcessStates::ConstPtr& message) {
        for (const FeedKeys& keys : trees) keys.configuration.Send(message->configuration);
      }));
  return subscribers;
}

}  // namespace coppice::robot
