#include "robot_app/assistance/page/page_node.h"

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>
#include <coppice_msgs/RestartProcess.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/console.h>

#include <utility>

#include "robot_app/assistance/page/page_texts.h"
#include "robot_app/common/service_call.h"

namespace coppice::robot::assistance {
namespace {

constexpr Duration kDrivePeriod = std::chrono::milliseconds(50);
constexpr Duration kPlacePeriod = std::chrono::milliseconds(200);
constexpr Duration kTreesPeriod = std::chrono::milliseconds(500);
constexpr Duration kPicturePeriod = std::chrono::milliseconds(180);  // five a second
constexpr double kScanLimit = 12;                                    // m
constexpr double kPositionVariance = 0.25;                           // m^2, of a finger on a map
constexpr double kYawVariance = 0.07;                                // rad^2, 15 degrees

teleoperation::TeleoperationSettings WheelSettings(const PageConfig& page) {
  teleoperation::TeleoperationSettings settings;
  settings.most_linear = page.most_linear;
  settings.most_angular = page.most_angular;
  settings.guard.stop_distance = page.stop_distance;
  return settings;
}

PageServerOptions ServerOptions(const PageConfig& page, const std::string& folder) {
  return {page.address, page.port, folder, page.public_url.compare(0, 8, "https://") == 0};
}

template <class Message, class Handler>
ros::Subscriber SubscribeTo(ros::NodeHandle& node, const std::string& topic, Handler handler) {
  return node.subscribe<Message>(
      topic, 1,
      boost::function<void(const boost::shared_ptr<Message const>&)>(
          [handler](const boost::shared_ptr<Message const>& message) { handler(*message); }));
}

}  // namespace

PageNode::PageNode(ros::NodeHandle& node, const AssistanceConfig& config, const std::string& folder,
                   const std::vector<Tree>& trees, Assistance& assistance, const Clock& clock)
    : node_(node),
      config_(config),
      clock_(clock),
      wheel_(WheelSettings(config.page)),
      desk_(config, assistance.desk(), wheel_, *this,
            [this](std::uint64_t client, const std::string& key, const PageDesk::Message& message,
                   bool is_binary) { server_.Send(client, key, message, is_binary); }),
      cameras_(config.page.cameras.size()),
      server_(ServerOptions(config.page, folder), assistance.access(), clock) {
  for (const Tree& tree : trees) {
    trees_.push_back({tree.name, std::make_unique<RunningPathFollower>(tree.endpoint)});
  }
  velocity_ = node.advertise<geometry_msgs::Twist>("/cmd_vel/supervisor", 1);
  initial_pose_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>("/initialpose", 1);
  Subscribe();
}

void PageNode::Subscribe() {
  subscribers_ = {
      SubscribeTo<coppice_msgs::Health>(
          node_, "/monitoring",
          [this](const coppice_msgs::Health& health) { desk_.Show("health", HealthText(health)); }),
      SubscribeTo<coppice_msgs::ProcessStates>(node_, "/processes",
                                               [this](const coppice_msgs::ProcessStates& states) {
                                                 desk_.Show("processes", ProcessesText(states));
                                               }),
      SubscribeTo<nav_msgs::OccupancyGrid>(
          node_, "/map", [this](const nav_msgs::OccupancyGrid& map) { OnMap(map); })};
}

void PageNode::OnMap(const nav_msgs::OccupancyGrid& map) {
  if (std::optional<std::string> bytes = MapBytes(map)) {
    desk_.ShowBytes("map", std::move(*bytes));
  } else {
    ROS_WARN("the map contradicts itself and is not shown");
  }
}

void PageNode::OnScan(const sensor_msgs::LaserScan& message) {
  const std::optional<LaserScan> scan = surroundings_->pose.UsableScan(message);
  if (!scan) return;
  surroundings_->scan = PointsInBase(*scan, kScanLimit);
  wheel_.SetObstacles(surroundings_->scan, clock_.Now());
}

void PageNode::Step() {
  const Time now = clock_.Now();
  for (PageEvent event; server_.Receive(event);) {
    const std::string line = desk_.OnEvent(event, now);
    if (!line.empty()) ROS_INFO_STREAM("page: " << line);
  }
  calls_.RunFinished();
  Drive(now);
  WatchSurroundings();
  WatchCameras();
  if (desk_.is_watched()) {
    ShowPlace(now);
    ShowTrees(now);
  }
  desk_.Step(now);
}

// Whoever holds the wheel also says so when the robot is to stand still.
void PageNode::Drive(Time now) {
  if (now - driven_at_ < kDrivePeriod) return;
  driven_at_ = now;
  if (const std::optional<Velocity2D> command = wheel_.Command(now)) {
    velocity_.publish(ToTwist(*command));
  }
}

void PageNode::WatchSurroundings() {
  if (!desk_.is_watched()) {
    surroundings_.reset();
  } else if (!surroundings_) {
    surroundings_.emplace().scans = SubscribeTo<sensor_msgs::LaserScan>(
        node_, "/scan", [this](const sensor_msgs::LaserScan& scan) { OnScan(scan); });
  }
}

void PageNode::WatchCameras() {
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    ros::Subscriber& subscriber = cameras_[i].subscriber;
    const bool is_watched = desk_.is_watched(i);
    if (is_watched && !subscriber) {
      subscriber = SubscribeTo<sensor_msgs::CompressedImage>(
          node_, config_.page.cameras[i].topic,
          [this, i](const sensor_msgs::CompressedImage& picture) { OnPicture(i, picture); });
    } else if (!is_watched && subscriber) {
      subscriber.shutdown();
      subscriber = {};
    }
  }
}

void PageNode::OnPicture(std::size_t camera, const sensor_msgs::CompressedImage& picture) {
  const Time now = clock_.Now();
  if (now - cameras_[camera].shown_at < kPicturePeriod) return;
  cameras_[camera].shown_at = now;
  desk_.ShowPicture(camera, picture.data.data(), picture.data.size());
}

void PageNode::ShowPlace(Time now) {
  if (now - place_at_ < kPlacePeriod) return;
  place_at_ = now;
  const std::optional<RobotPose::Stamped> pose = surroundings_->pose.Newest();
  desk_.Show("place",
             PlaceText(pose ? std::make_optional(pose->pose) : std::nullopt, surroundings_->scan));
}

void PageNode::ShowTrees(Time now) {
  if (now - trees_at_ < kTreesPeriod) return;
  trees_at_ = now;
  std::vector<TreeText> trees;
  for (const FollowedTree& tree : trees_) {
    RunningPathFollower::View view = tree.follower->Now();
    trees.push_back({tree.name, view.is_live, std::move(view.path)});
  }
  const std::string text = TreesText(trees);
  if (text == trees_text_) return;
  trees_text_ = text;
  desk_.Show("trees", text);
}

void PageNode::SetPose(const Pose2D& pose) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = "map";
  message.pose.pose = ToPoseMessage(pose);
  message.pose.covariance[0] = kPositionVariance;
  message.pose.covariance[7] = kPositionVariance;
  message.pose.covariance[35] = kYawVariance;
  initial_pose_.publish(message);
}

void PageNode::Restart(const std::string& name,
                       std::function<void(bool ok, const std::string& text)> done) {
  const bool is_accepted = calls_.Add([name, done]() -> ServiceCaller::Finish {
    coppice_msgs::RestartProcess service;
    service.request.name = name;
    if (!CallService("/supervisor/restart", service)) {
      return [done] { done(false, "The process supervisor does not answer."); };
    }
    const bool ok = service.response.ok;
    const std::string text = service.response.message;
    return [done, ok, text] { done(ok, text); };
  });
  if (!is_accepted) done(false, "Too many restarts wait already.");
}

}  // namespace coppice::robot::assistance
