#include "robot_app/ros/feeds.h"

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>
#include <sensor_msgs/BatteryState.h>

#include <cmath>
#include <utility>

#include "robot_app/processes/processes_view.h"

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

// What a driver does not measure it reports as NaN.
BatteryReading FromMessage(const sensor_msgs::BatteryState& message, Time stamp) {
  BatteryReading reading;
  reading.stamp = stamp;
  reading.voltage = std::isfinite(message.voltage) ? message.voltage : 0;
  reading.current = std::isfinite(message.current) ? message.current : 0;
  reading.level = std::isfinite(message.percentage) ? message.percentage : -1;
  return reading;
}

}  // namespace

std::vector<ros::Subscriber> SubscribeFeeds(ros::NodeHandle& node,
                                            const std::vector<FeedKeys>& trees,
                                            const Clock& clock) {
  for (const FeedKeys& keys : trees) keys.configuration.Send("");
  std::vector<ros::Subscriber> subscribers;
  subscribers.push_back(node.subscribe<sensor_msgs::BatteryState>(
      "/battery_state", 1, [trees, &clock](const sensor_msgs::BatteryState::ConstPtr& message) {
        const BatteryReading reading = FromMessage(*message, clock.Now());
        const bool charging =
            message->power_supply_status == sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_CHARGING;
        for (const FeedKeys& keys : trees) {
          keys.battery_level.Send(message->percentage);
          keys.charging.Send(charging);
          keys.battery.Send(reading);
        }
      }));
  subscribers.push_back(node.subscribe<coppice_msgs::Health>(
      "/monitoring", 1, [trees, &clock](const coppice_msgs::Health::ConstPtr& message) {
        const Health health = FromMessage(*message, clock.Now());
        for (const FeedKeys& keys : trees) keys.monitoring.Send(health);
      }));
  subscribers.push_back(node.subscribe<coppice_msgs::ProcessStates>(
      "/processes", 1,
      [trees, rows = std::string()](const coppice_msgs::ProcessStates::ConstPtr& message) mutable {
        std::string now = ToJsonRows(*message);
        for (const FeedKeys& keys : trees) {
          keys.configuration.Send(message->configuration);
          keys.manual.Send(message->manual);
          if (now != rows) keys.processes.Send(now);
        }
        rows = std::move(now);
      }));
  return subscribers;
}

}  // namespace coppice::robot
