// The supervisor page on ROS: what the robot publishes is shown, what people do is carried out.
// Thin: PageDesk decides. For the thread that spins.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_NODE_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_NODE_H_

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CompressedImage.h>

#include <optional>
#include <string>
#include <vector>

#include "robot_app/assistance/assistance.h"
#include "robot_app/assistance/page/page_desk.h"
#include "robot_app/assistance/page/page_server.h"
#include "robot_app/assistance/page/running_path.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/service_caller.h"

namespace coppice::robot::assistance {

class PageNode : public PageRobot {
 public:
  struct Tree {
    std::string name;
    std::string endpoint;  ///< of its live socket
  };

  /// Serves the page when it returns. Throws std::runtime_error if its port cannot be had. `config`
  /// and the rest must live longer.
  PageNode(ros::NodeHandle& node, const AssistanceConfig& config, const std::string& folder,
           const std::vector<Tree>& trees, Assistance& assistance, const Clock& clock);

  std::uint16_t port() const { return server_.port(); }

  /// Call it at least 20 times a second.
  void Step();

  void SetPose(const Pose2D& pose) override;
  void Restart(const std::string& name,
               std::function<void(bool ok, const std::string& text)> done) override;

 private:
  struct Camera {
    ros::Subscriber subscriber;
    Time shown_at{};
  };
  struct Surroundings {
    RobotPose pose{{"map", "odom", "base_link"}};
    std::vector<Point2D> scan;
    ros::Subscriber scans;
  };
  struct FollowedTree {
    std::string name;
    std::unique_ptr<RunningPathFollower> follower;
  };

  void Subscribe();
  void OnMap(const nav_msgs::OccupancyGrid& map);
  void OnScan(const sensor_msgs::LaserScan& message);
  void WatchSurroundings();
  void WatchCameras();
  void OnPicture(std::size_t camera, const sensor_msgs::CompressedImage& picture);
  void Drive(Time now);
  void ShowPlace(Time now);
  void ShowTrees(Time now);

  ros::NodeHandle& node_;
  const AssistanceConfig& config_;
  const Clock& clock_;
  teleoperation::Teleoperation wheel_;
  PageDesk desk_;
  std::optional<Surroundings> surroundings_;  // while the page is open: transforms come often
  std::vector<Camera> cameras_;
  std::vector<FollowedTree> trees_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher velocity_;
  ros::Publisher initial_pose_;
  Time driven_at_{};
  Time place_at_{};
  Time trees_at_{};
  std::string trees_text_;
  ServiceCaller calls_;
  PageServer server_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_NODE_H_
