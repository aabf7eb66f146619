// coppice-velocity-mux: node /velocity_mux. The only one that publishes /cmd_vel: a person who
// drives (/cmd_vel/supervisor) goes before what the robot does by itself (/cmd_vel/autonomous).
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include <cmath>

#include "bt_core/base/clock.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/teleoperation/velocity_mux.h"

namespace coppice::robot::teleoperation {
namespace {

constexpr char kHelp[] =
    "coppice-velocity-mux\n"
    "The node /velocity_mux.\n"
    "  subscribes  /cmd_vel/supervisor, /cmd_vel/autonomous (geometry_msgs/Twist)\n"
    "  publishes   /cmd_vel: the supervisor's commands as long as there are some, else the "
    "others;\n"
    "              zero once when the one that drives has said nothing for 0.5 s of wall time\n";

constexpr const char* kTopics[] = {"/cmd_vel/supervisor", "/cmd_vel/autonomous"};
constexpr Duration kTimeout = std::chrono::milliseconds(500);

class Program {
 public:
  Program() {
    output_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
    for (std::size_t i = 0; i < std::size(kTopics); ++i) {
      inputs_.push_back(node_.subscribe<geometry_msgs::Twist>(
          kTopics[i], 1,
          [this, i](const geometry_msgs::Twist::ConstPtr& twist) { OnCommand(i, *twist); },
          ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
    }
    timer_ = node_.createWallTimer(ros::WallDuration(0.05), [this](const ros::WallTimerEvent&) {
      if (mux_.MustStop(clock_.Now())) output_.publish(geometry_msgs::Twist());
    });
  }

 private:
  void OnCommand(std::size_t source, const geometry_msgs::Twist& twist) {
    if (!std::isfinite(twist.linear.x) || !std::isfinite(twist.angular.z)) return;
    if (!mux_.Offer(source, {twist.linear.x, twist.angular.z}, clock_.Now())) return;
    geometry_msgs::Twist command;  // nothing else: nobody has looked at the rest of what was sent
    command.linear.x = twist.linear.x;
    command.angular.z = twist.angular.z;
    output_.publish(command);
  }

  const WallClock clock_;
  VelocityMux mux_{{kTimeout, kTimeout}};
  ros::NodeHandle node_;
  ros::Publisher output_;
  std::vector<ros::Subscriber> inputs_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot::teleoperation

int main(int argc, char** argv) {
  using namespace coppice::robot::teleoperation;  // NOLINT: the whole program
  if (const auto status = coppice::robot::StartNode(argc, argv, "velocity_mux", kHelp)) {
    return *status;
  }
  const Program program;
  ros::spin();
  return 0;
}
