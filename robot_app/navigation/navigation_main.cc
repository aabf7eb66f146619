// coppice-navigation: the library of this folder as the ROS node /navigation.
#include <coppice_msgs/MotionAction.h>
#include <coppice_msgs/NavigationState.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/common/actions/goal_server.h"
#include "robot_app/common/places/station_place.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/navigation/navigation.h"
#include "robot_app/navigation/relative_motion.h"
#include "robot_app/navigation/way_field.h"

namespace coppice::robot::navigation {
namespace {

constexpr char kHelp[] =
    "coppice-navigation: drives the robot to goals, as the ROS node /navigation.\n"
    "  actions     move_base (move_base_msgs/MoveBase), motion (coppice_msgs/Motion)\n"
    "  service     move_base/make_plan (nav_msgs/GetPlan): the way from a pose, or from here if\n"
    "              the frame of the start is empty, around what it sees; fails if there is none\n"
    "  subscribes  /map /scan /sonar/left /sonar/front /sonar/right /odom /tf /tf_static,\n"
    "              /navigation/speed_limit (std_msgs/Float64 [m/s], holds for two seconds)\n"
    "  publishes   /cmd_vel (only while moving), /navigation/state, /navigation/path,\n"
    "              /navigation/way_to_station (with ~places, as long as there is a way on the "
    "map)\n"
    "A motion holds up a running goal, which goes on afterwards.\n";

constexpr double kControlPeriod = 0.05;  // ROS time [s]
constexpr double kStatePeriod = 0.5;     // ROS time [s]
constexpr double kSpeedLimitHolds = 2;   // ROS time [s]

struct Settings {
  NavigationSettings navigation;
  RelativeMotionSettings motion;
  Frames frames;
  double clearance = 0.05;  // planned beyond the robot's radius [m]
  std::string places = "none";
  std::optional<Pose2D> station;  // on the map
};

Parameters ParametersOf(Settings& settings) {
  NavigationSettings& navigation = settings.navigation;
  FollowerSettings& follower = navigation.follower;
  return WithFrames(
      {{"max_speed", &follower.max_speed, 0.05, 3, "[m/s]"},
       {"max_turn", &follower.max_turn, 0.05, 6, "[rad/s]"},
       {"acceleration", &follower.acceleration, 0.05, 10, "[m/s^2]"},
       {"turn_acceleration", &follower.turn_acceleration, 0.05, 20, "[rad/s^2]"},
       {"robot_radius", &follower.robot_radius, 0.05, 3, "[m]"},
       {"clearance", &settings.clearance, 0.02, 1, "planned beyond the radius [m]"},
       {"inflation_radius", &navigation.costs.inflation_radius, 0.1, 5, "keeps away so far [m]"},
       {"goal_tolerance", &follower.goal_tolerance, 0.03, 2, "[m]"},
       {"goal_yaw_tolerance", &follower.goal_yaw_tolerance, 0.02, 4, "[rad]"},
       {"patience", &navigation.patience, 0, 3600, "waits so long before it recovers [s]"},
       {"forget_obstacles_after", &navigation.obstacles.forget_after, 0.1, 36000, "[s]"},
       {"sonar_range", &navigation.sonar.mark_range, 0, 10, "echoes from farther mark nothing [m]"},
       {"forget_echoes_after", &navigation.sonar.forget_after, 0.1, 60, "[s]"},
       {"sensor_timeout", &navigation.sensor_timeout, 0.1, 60, "an older pose does not count [s]"},
       {"places", &settings.places, "file with the place of the category \"station\""}},
      settings.frames);
}

// What follows from the parameters.
void Derive(Settings& settings) {
  const double radius = settings.navigation.follower.robot_radius;
  settings.navigation.costs.lethal_radius = radius + settings.clearance;
  settings.motion.robot_radius = radius;
}

class NavigationNode {
 public:
  explicit NavigationNode(const Settings& settings)
      : settings_(settings),
        navigation_(settings.navigation),
        motion_(settings.motion),
        pose_(settings.frames),
        move_base_(
            node_, "move_base", [this](const auto& goal) { OnGoal(goal); }, [this] { OnCancel(); }),
        motion_server_(
            node_, "motion", [this](const auto& goal) { OnMotion(goal); },
            [this] { EndMotion(false, "cancelled", true); }) {
    command_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
    state_ = node_.advertise<coppice_msgs::NavigationState>("/navigation/state", 10);
    way_ = node_.advertise<std_msgs::Float64>("/navigation/way_to_station", 10);
    path_ = node_.advertise<nav_msgs::Path>("/navigation/path", 1, true);
    Subscribe();
    make_plan_ = node_.advertiseService<nav_msgs::GetPlan::Request, nav_msgs::GetPlan::Response>(
        "move_base/make_plan",
        [this](auto& request, auto& response) { return MakePlan(request, response); });
    move_base_.Start();
    motion_server_.Start();
    control_timer_ = node_.createTimer(ros::Duration(kControlPeriod),
                                       [this](const ros::TimerEvent&) { Control(); });
    state_timer_ = node_.createTimer(ros::Duration(kStatePeriod), [this](const ros::TimerEvent&) {
      PublishState();
      PublishWay();
    });
  }

 private:
  static double Now() { return ros::Time::now().toSec(); }

  void Subscribe() {
    subscribers_.push_back(node_.subscribe<nav_msgs::OccupancyGrid>(
        "/map", 1, [this](const nav_msgs::OccupancyGrid::ConstPtr& message) {
          Expected<OccupancyGrid> grid = ToGrid(*message);
          if (!grid) {
            ROS_ERROR("%s; it is not used", grid.problem().c_str());
            return;
          }
          MeasureWays(*grid);
          navigation_.SetMap(std::move(*grid));
        }));
    subscribers_.push_back(node_.subscribe<sensor_msgs::LaserScan>(
        "/scan", 1, [this](const sensor_msgs::LaserScan::ConstPtr& message) { OnScan(*message); }));
    for (const char* const topic : {"/sonar/left", "/sonar/front", "/sonar/right"}) {
      subscribers_.push_back(node_.subscribe<sensor_msgs::Range>(
          topic, 1, [this, topic](const sensor_msgs::Range::ConstPtr& message) {
            OnRange(*message, topic);
          }));
    }
    subscribers_.push_back(node_.subscribe<std_msgs::Float64>(
        "/navigation/speed_limit", 1,
        [this](const std_msgs::Float64::ConstPtr& message) { OnSpeedLimit(message->data); }));
    subscribers_.push_back(node_.subscribe<nav_msgs::Odometry>(
        "/odom", 1, [this](const nav_msgs::Odometry::ConstPtr& message) {
          const auto stamp = StampOfNow(message->header, "/odom");
          if (!stamp || !IsValid(message->pose.pose)) return;
          odometry_ = ToPose2D(message->pose.pose);
          odometry_stamp_ = *stamp;
        }));
  }

  // On the map alone: what stands in the way today may be gone tomorrow.
  void MeasureWays(const OccupancyGrid& map) {
    if (!settings_.station) return;
    Costmap costs(settings_.navigation.costs);
    costs.Update(map);
    ways_.emplace(costs, Point2D{settings_.station->x, settings_.station->y});
  }

  void OnScan(const sensor_msgs::LaserScan& message) {
    const auto scan = pose_.UsableScan(message);
    if (!scan) return;
    scan_stamp_ = scan->stamp;
    points_ = PointsInBase(*scan, 3);
    if (const auto pose = pose_.At(message.header.stamp)) navigation_.AddScan(*pose, *scan);
  }

  void OnRange(const sensor_msgs::Range& message, const char* topic) {
    const auto mount = pose_.MountOf(message.header.frame_id);
    const auto pose = pose_.At(message.header.stamp);
    if (!mount || !pose) return;
    const Outcome entered = navigation_.AddRange(*pose, ToRangeReading(message, *mount), Now());
    if (!entered) ROS_WARN_THROTTLE(10, "%s is not used: %s", topic, entered.problem().c_str());
  }

  void OnSpeedLimit(double speed) {
    if (!(speed > 0)) return;  // nor NaN
    navigation_.LimitSpeed(speed);
    speed_limit_at_ = Now();
  }

  void OnGoal(const move_base_msgs::MoveBaseGoal& goal) {
    const auto refuse = [this](const std::string& why) {
      navigation_.Cancel(Now());
      move_base_.Abort({}, why);
      ROS_WARN("goal refused: %s", why.c_str());
    };
    if (!IsValid(goal.target_pose.pose)) return refuse("the goal's pose is not valid");
    const auto pose = pose_.InMap(goal.target_pose);
    if (!pose) {
      return refuse("tf does not know the goal's frame " + goal.target_pose.header.frame_id);
    }
    ROS_INFO("goal (%.2f, %.2f, %.2f)", pose->x, pose->y, pose->yaw);
    navigation_.SetGoal(*pose, Now());
    busy_ = true;
  }

  // As the service of move_base, which may be asked at any time here.
  bool MakePlan(const nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response) {
    const auto here = pose_.Newest();
    const bool from_here = request.start.header.frame_id.empty();
    if (!IsValid(request.goal.pose) || (!from_here && !IsValid(request.start.pose))) return false;
    const auto goal = pose_.InMap(request.goal);
    const auto start =
        from_here ? here ? std::optional(here->pose) : std::nullopt : pose_.InMap(request.start);
    if (!goal || !start) return false;
    const Plan plan = navigation_.FindWay(*start, {goal->x, goal->y}, Now());
    response.plan = PathMessage(plan.points);
    return plan.status == PlanStatus::kOk;
  }

  void OnCancel() {
    navigation_.Cancel(Now());
    move_base_.Cancel({}, "cancelled");
  }

  void OnMotion(const coppice_msgs::MotionGoal& goal) {
    // Where time was set back what is known is old, too.
    const bool blind = goal.distance > 0 && std::abs(Now() - scan_stamp_) > 1;
    if (std::abs(Now() - odometry_stamp_) > 1) return EndMotion(false, "there is no odometry");
    if (blind) return EndMotion(false, "there is no laser scan");
    motion_.Start(odometry_, goal.distance, goal.angle, goal.speed, commanded_);
    motion_update_ = Now();
    busy_ = true;
  }

  void EndMotion(bool ok, const std::string& message, bool cancelled = false) {
    coppice_msgs::MotionResult result;
    result.ok = ok;
    result.message = message;
    if (cancelled) {
      motion_server_.Cancel(result, message);
    } else if (ok) {
      motion_server_.Succeed(result, message);
    } else {
      motion_server_.Abort(result, message);
      ROS_WARN("motion failed: %s", message.c_str());
    }
    // The robot has been moved by something else than the goal's path.
    navigation_.Restart(Now());
  }

  void Control() {
    const double now = Now();
    // Also where time was set back.
    if (std::abs(now - speed_limit_at_) > kSpeedLimitHolds) navigation_.LimitSpeed(HUGE_VAL);
    const Velocity2D velocity = motion_server_.is_active() ? MotionStep(now) : NavigationStep(now);
    Publish(velocity);
    if (navigation_.path_number() != published_path_) PublishPath();
    if (navigation_.status() != published_status_ || published_failures_ != Failures()) {
      PublishState();
    }
  }

  Velocity2D MotionStep(double now) {
    const double seconds = std::clamp(now - motion_update_, 0.0, 0.2);
    motion_update_ = now;
    if (now - odometry_stamp_ > 1) {
      EndMotion(false, "odometry has fallen silent");
      return {};
    }
    if (now - scan_stamp_ > 1 && motion_.looks_ahead()) {
      EndMotion(false, "the laser scan has fallen silent");
      return {};
    }
    std::vector<Point2D> obstacles = points_;
    if (const auto pose = pose_.Newest()) navigation_.AddHeard(pose->pose, obstacles);
    const Velocity2D velocity = motion_.Update(odometry_, obstacles, seconds);
    if (motion_.state() == RelativeMotion::State::kMoving) {
      coppice_msgs::MotionFeedback feedback;
      feedback.remaining = motion_.remaining();
      motion_server_.Publish(feedback);
      return velocity;
    }
    EndMotion(motion_.state() == RelativeMotion::State::kDone, motion_.message());
    return {};
  }

  Velocity2D NavigationStep(double now) {
    const auto pose = pose_.Newest();
    const bool active = move_base_.is_active();
    const Velocity2D velocity =
        navigation_.Update(now, pose ? pose->pose : Pose2D(), pose ? pose->stamp : -HUGE_VAL);
    if (!active) return velocity;
    if (pose) {
      move_base_msgs::MoveBaseFeedback feedback;
      feedback.base_position.header.frame_id = settings_.frames.map;
      feedback.base_position.header.stamp = ros::Time(pose->stamp);
      feedback.base_position.pose = ToPoseMessage(pose->pose);
      move_base_.Publish(feedback);
    }
    if (navigation_.end() == Navigation::End::kReached) {
      move_base_.Succeed({}, navigation_.message());
      ROS_INFO("%s", navigation_.message().c_str());
    } else if (navigation_.end() == Navigation::End::kAborted) {
      move_base_.Abort({}, navigation_.message());
      ROS_WARN("goal aborted: %s", navigation_.message().c_str());
    }
    return velocity;
  }

  // Silent when idle, so that others may drive; the last command is always zero.
  void Publish(const Velocity2D& velocity) {
    const bool working = move_base_.is_active() || motion_server_.is_active();
    const bool standing = velocity.linear == 0 && velocity.angular == 0;
    if (!busy_ && !working && standing) return;
    command_.publish(ToTwist(velocity));
    commanded_ = velocity;
    busy_ = working || !standing;
  }

  std::uint32_t Failures() const {
    return static_cast<std::uint32_t>(navigation_.consecutive_failures());
  }

  void PublishState() {
    coppice_msgs::NavigationState state;
    state.header.stamp = ros::Time::now();
    state.state = static_cast<std::uint8_t>(navigation_.status());
    state.seconds_in_state = std::max(0.0, Now() - navigation_.status_since());
    state.consecutive_failures = Failures();
    state.message = navigation_.message();
    state_.publish(state);
    published_status_ = navigation_.status();
    published_failures_ = state.consecutive_failures;
  }

  void PublishWay() {
    const auto pose = pose_.Newest();
    if (!ways_ || !pose) return;
    const auto length = ways_->Length({pose->pose.x, pose->pose.y});
    if (!length) return;
    std_msgs::Float64 way;
    way.data = *length;
    way_.publish(way);
  }

  nav_msgs::Path PathMessage(const std::vector<Point2D>& points) const {
    nav_msgs::Path path;
    path.header.stamp = ros::Time::now();
    path.header.frame_id = settings_.frames.map;
    for (const Point2D& point : points) {
      geometry_msgs::PoseStamped pose;
      pose.header = path.header;
      pose.pose = ToPoseMessage({point.x, point.y, 0});
      path.poses.push_back(pose);
    }
    return path;
  }

  void PublishPath() {
    path_.publish(PathMessage(navigation_.path()));
    published_path_ = navigation_.path_number();
  }

  Settings settings_;
  ros::NodeHandle node_;
  Navigation navigation_;
  RelativeMotion motion_;
  RobotPose pose_;
  std::optional<WayField> ways_;  // to the station
  std::vector<Point2D> points_;   // of the newest scan, in base_link
  double scan_stamp_ = 0;
  Pose2D odometry_;
  double odometry_stamp_ = 0;
  double motion_update_ = 0;
  double speed_limit_at_ = -kSpeedLimitHolds;  // when it was told
  Velocity2D commanded_;                       // last
  bool busy_ = false;                          // commands are being published
  int published_path_ = 0;
  NavigationStatus published_status_ = NavigationStatus::kIdle;
  std::uint32_t published_failures_ = 0;

  GoalServer<move_base_msgs::MoveBaseAction> move_base_;
  GoalServer<coppice_msgs::MotionAction> motion_server_;
  ros::ServiceServer make_plan_;
  ros::Publisher command_;
  ros::Publisher state_;
  ros::Publisher path_;
  ros::Publisher way_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Timer control_timer_;
  ros::Timer state_timer_;
};

}  // namespace
}  // namespace coppice::robot::navigation

int main(int argc, char** argv) {
  using namespace coppice::robot::navigation;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(argc, argv, "navigation", kHelp, [](Settings& settings) {
    Derive(settings);
    if (!coppice::robot::ReadHome(settings.places, settings.station)) return 2;
    NavigationNode node(settings);
    ros::spin();
    return 0;
  });
}
