// coppice-odometry-filter: the filter of this folder as the ROS node /odometry_filter.
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/Imu.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>
#include <string>

#include "robot_app/common/ros_support.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/localization/odometry_filter.h"

namespace coppice::robot::localization {
namespace {

constexpr char kHelp[] =
    "coppice-odometry-filter: fuses wheels and gyroscope, as the ROS node /odometry_filter.\n"
    "  subscribes  /odom (the velocities), /imu/data (the yaw rate)\n"
    "  publishes   /odometry/filtered with covariances, tf odom -> base_link\n"
    "Begins at the pose of the wheels. Silent without wheels; without the gyroscope the wheels do\n"
    "alone.\n";

constexpr double kWithoutWheels = 0.5;  // an older report of the wheels says nothing [s]

struct Settings {
  OdometryFilterSettings filter;
  double frequency = 30;
  Frames frames;
};

Parameters ParametersOf(Settings& settings) {
  OdometryFilterSettings& filter = settings.filter;
  return {
      {"frequency", &settings.frequency, 1, 1000, "of what it publishes [Hz]"},
      {"acceleration", &filter.acceleration, 0.001, 100, "change of the speed in 1 s [m/s]"},
      {"turn_acceleration", &filter.turn_acceleration, 0.001, 100, "of the yaw rate [rad/s]"},
      {"speed_noise", &filter.speed_noise, 1e-5, 10, "of the wheels at rest [m/s]"},
      {"speed_slip", &filter.speed_slip, 0, 10, "more of it for each m/s and rad/s"},
      {"turn_noise", &filter.turn_noise, 1e-5, 10, "of the wheels at rest [rad/s]"},
      {"turn_slip", &filter.turn_slip, 0, 10, "more of it for each m/s and rad/s"},
      {"gyro_noise", &filter.gyro_noise, 1e-6, 10, "if /imu/data does not tell it [rad/s]"},
      {"odom_frame", &settings.frames.odom, "the frame of the odometry"},
      {"base_frame", &settings.frames.base, "of the robot"},
  };
}

class OdometryFilterNode {
 public:
  explicit OdometryFilterNode(const Settings& settings)
      : settings_(settings), filter_(settings.filter) {
    odometry_ = node_.advertise<nav_msgs::Odometry>("/odometry/filtered", 20);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 50);
    const auto hints = ros::TransportHints().tcpNoDelay();
    wheels_ = node_.subscribe<nav_msgs::Odometry>(
        "/odom", 10,
        boost::function<void(const nav_msgs::Odometry::ConstPtr&)>(
            [this](const nav_msgs::Odometry::ConstPtr& message) { OnWheels(*message); }),
        ros::VoidConstPtr(), hints);
    imu_ = node_.subscribe<sensor_msgs::Imu>(
        "/imu/data", 20,
        boost::function<void(const sensor_msgs::Imu::ConstPtr&)>(
            [this](const sensor_msgs::Imu::ConstPtr& message) { OnImu(*message); }),
        ros::VoidConstPtr(), hints);
  }

 private:
  void OnWheels(const nav_msgs::Odometry& message) {
    const auto stamp = StampOfNow(message.header, "/odom");
    if (!stamp) return;
    if (!IsValid(message.pose.pose) ||
        !filter_.AddWheels(*stamp, ToPose2D(message.pose.pose),
                           {message.twist.twist.linear.x, message.twist.twist.angular.z})) {
      ROS_WARN_THROTTLE(10, "a report of the wheels is not used: it cannot be");
      return;
    }
    if (*stamp < next_ - 2 / settings_.frequency) next_ = *stamp;  // time was set back
    Publish();
  }

  void OnImu(const sensor_msgs::Imu& message) {
    const auto stamp = StampOfNow(message.header, "/imu/data");
    if (stamp && filter_.AddYawRate(*stamp, message.angular_velocity.z,
                                    message.angular_velocity_covariance[8])) {
      Publish();
    }
  }

  // At the stamps of the measurements, so often that the frequency is held on average.
  void Publish() {
    const double stamp = filter_.stamp();
    if (stamp < next_ || stamp == published_) return;
    if (stamp - filter_.wheels_stamp() > kWithoutWheels) return;
    published_ = stamp;
    next_ = std::max(next_ + 1 / settings_.frequency, stamp - 1 / settings_.frequency);
    nav_msgs::Odometry message;
    message.header.stamp = ros::Time(stamp);
    message.header.frame_id = settings_.frames.odom;
    message.child_frame_id = settings_.frames.base;
    message.pose.pose = ToPoseMessage(filter_.pose());
    message.twist.twist = ToTwist(filter_.velocity());
    const OdometryFilter::Matrix& covariance = filter_.covariance();
    constexpr int kPoseRows[] = {0, 1, 5};  // x, y, yaw of the six
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        message.pose.covariance[6 * kPoseRows[i] + kPoseRows[j]] = covariance(i, j);
      }
    }
    constexpr int kTwistRows[] = {0, 5};  // forward, yaw rate
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        message.twist.covariance[6 * kTwistRows[i] + kTwistRows[j]] = covariance(3 + i, 3 + j);
      }
    }
    odometry_.publish(message);
    tf2_msgs::TFMessage tf;
    tf.transforms.resize(1);
    tf.transforms[0].header = message.header;
    tf.transforms[0].child_frame_id = settings_.frames.base;
    tf.transforms[0].transform.translation.x = message.pose.pose.position.x;
    tf.transforms[0].transform.translation.y = message.pose.pose.position.y;
    tf.transforms[0].transform.rotation = message.pose.pose.orientation;
    tf_.publish(tf);
  }

  Settings settings_;
  ros::NodeHandle node_;
  OdometryFilter filter_;
  double next_ = 0;  // stamp of what is published next
  double published_ = 0;
  ros::Publisher odometry_;
  ros::Publisher tf_;
  ros::Subscriber wheels_;
  ros::Subscriber imu_;
};

}  // namespace
}  // namespace coppice::robot::localization

int main(int argc, char** argv) {
  using namespace coppice::robot::localization;  // NOLINT: the whole program
  return coppice::robot::SpinNode<OdometryFilterNode, Settings>(argc, argv, "odometry_filter",
                                                                kHelp);
}
