#include "robot_app/ros/feeds.h"

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>
#include <sensor_msgs/BatteryState.h>

#include <cmath>
#include <optional>
#include <utility>

#include "robot_app/common/battery_message.h"
#include "robot_app/processes/processes_view.h"

namespace coppice::robot::adapters {
namespace {

using leaves::Health;

Health FromMessage(const coppice_msgs::Health& message, Time stamp) {
  Health health;
  health.stamp = stamp;
  for (const coppice_msgs::HealthEntry& entry : message.entries) {
    health.entries.push_back({entry.monitor, entry.subject, entry.node,
                              leaves::LevelOfNumber(entry.level), entry.message});
  }
  return health;
}

// Readings without a level are no news for so long, then the level is unknown.
constexpr Duration kLevelHolds = std::chrono::seconds(10);
constexpr double kUnknownLevel = -1;

// Hands on what the battery says.
class BatteryFeed {
 public:
  explicit BatteryFeed(std::vector<FeedKeys> trees) : trees_(std::move(trees)) {}

  void OnReading(const leaves::BatteryReading& reading) {
    const std::optional<double> level = Level(reading);
    const std::optional<bool> charging = leaves::CurrentFlows(reading);
    const std::optional<bool> docked = leaves::StandsOnStation(reading);
    for (const FeedKeys& keys : trees_) {
      if (level) keys.battery_level.Send(*level);
      if (charging) keys.charging.Send(*charging);
      if (docked) keys.docked.Send(*docked);
      keys.battery.Send(reading);
    }
  }

 private:
  // Nothing: what was known last holds.
  std::optional<double> Level(const leaves::BatteryReading& reading) {
    const bool is_measured = !std::isnan(reading.level);
    if (is_measured || !measured_at_) measured_at_ = reading.stamp;
    if (is_measured) return reading.level;
    return reading.stamp - *measured_at_ < kLevelHolds ? std::nullopt
                                                       : std::optional(kUnknownLevel);
  }

  std::vector<FeedKeys> trees_;
  std::optional<Time> measured_at_;  // the level, or the first reading
};

}  // namespace

std::vector<ros::Subscriber> SubscribeFeeds(ros::NodeHandle& node,
                                            const std::vector<FeedKeys>& trees,
                                            const Clock& clock) {
  for (const FeedKeys& keys : trees) {
    keys.configuration.Send("");
    keys.site.Send("");
  }
  std::vector<ros::Subscriber> subscribers;
  subscribers.push_back(node.subscribe<sensor_msgs::BatteryState>(
      "/battery_state", 1,
      [feed = BatteryFeed(trees),
       &clock](const sensor_msgs::BatteryState::ConstPtr& message) mutable {
        feed.OnReading(ToBatteryReading(*message, clock.Now()));
      }));
  subscribers.push_back(node.subscribe<coppice_msgs::Health>(
      "/monitoring", 1, [trees, &clock](const coppice_msgs::Health::ConstPtr& message) {
        const Health health = FromMessage(*message, clock.Now());
        for (const FeedKeys& keys : trees) keys.monitoring.Send(health);
      }));
  subscribers.push_back(node.subscribe<coppice_msgs::ProcessStates>(
      "/processes", 1,
      [trees, rows = std::string()](const coppice_msgs::ProcessStates::ConstPtr& message) mutable {
        std::string now = processes::ToJsonRows(*message);
        for (const FeedKeys& keys : trees) {
          keys.configuration.Send(message->configuration);
          keys.site.Send(message->site);
          keys.manual.Send(message->manual);
          if (now != rows) keys.processes.Send(now);
        }
        rows = std::move(now);
      }));
  return subscribers;
}

}  // namespace coppice::robot::adapters
