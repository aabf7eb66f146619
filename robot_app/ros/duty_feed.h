// Tells the trees how long the robot is still on duty: nights and weekends it rests on its station.
#ifndef COPPICE_ROBOT_APP_ROS_DUTY_FEED_H_
#define COPPICE_ROBOT_APP_ROS_DUTY_FEED_H_

#include <ros/node_handle.h>

#include <ctime>
#include <vector>

#include "bt_core/data/inbox.h"
#include "robot_app/knowledge/store/opening_hours.h"

namespace coppice::robot::adapters {

/// What clocks on the wall show where the computer is (environment variable TZ, /etc/localtime).
knowledge::LocalTime LocalTimeAt(std::time_t moment);

/// Every ten seconds of the computer's clock, as long as it lives; also in a simulation, whose
/// clock knows no day.
class DutyFeed {
 public:
  /// `trees`: their keys `duty_left`, until the end of the working hours [s], 0 outside of them.
  DutyFeed(ros::NodeHandle& node, knowledge::OpeningHours hours, std::vector<Sender<double>> trees);

 private:
  void Send();

  knowledge::OpeningHours hours_;
  std::vector<Sender<double>> trees_;
  ros::WallTimer timer_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_DUTY_FEED_H_
