// What flows from ROS topics onto the blackboards: each feed turns messages into values and posts
// them to the trees that use the key. Callbacks run on the spinner; the trees see the values at
// their next tick.
#ifndef COPPICE_ROBOT_APP_ROS_FEEDS_H_
#define COPPICE_ROBOT_APP_ROS_FEEDS_H_

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/inbox.h"
#include "bt_nodes/monitoring/health.h"
#include "bt_nodes/power/battery_reading.h"

namespace coppice::robot::adapters {

/// The keys that the feeds write. A tree that does not use a key gives an empty sender.
struct FeedKeys {
  /// State of charge, 0..1, from /battery_state; -1 when it has not been measured for ten seconds.
  Sender<double> battery_level;
  Sender<bool> charging;              ///< current flows into the battery, from /battery_state
  Sender<bool> docked;                ///< the station's contacts touch, from /battery_state
  Sender<leaves::Health> monitoring;  ///< aggregated reports, from /monitoring, stamped on arrival
  Sender<std::string> configuration;  ///< in force, from /processes; empty until it is known
  Sender<std::string> site;           ///< where the robot is, from /processes; empty until known
  Sender<bool> manual;                ///< it was set by hand, from /processes
  Sender<std::string> processes;      ///< JSON rows of /processes, sent when they have changed
  Sender<leaves::BatteryReading> battery;  ///< raw, from /battery_state, stamped on arrival
};

/// Subscribes as long as the returned subscribers live. The clock stamps what arrives. What the
/// battery does not tell about `charging` and `docked` is not sent: what was known last holds.
std::vector<ros::Subscriber> SubscribeFeeds(ros::NodeHandle& node,
                                            const std::vector<FeedKeys>& trees, const Clock& clock);

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_FEEDS_H_
