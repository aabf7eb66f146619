// Follows people through what the lidar, the cameras and the planar laser tell, message by message;
// the same for a robot that runs and for a record of it.
//
//   PeopleFollower follower(options, *Classifiers::Load(clouds, legs), find_transform);
//   if (Outcome done = follower.OnCloud(message); done) Publish(follower.tracker());
//
// Each kind of message alone is enough: when the lidar is dead the cameras go on, and the other way
// round. While the lidar tells of people, scans of the laser are not looked at: the legs in them
// would add nothing but some false people.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_FOLLOWER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_FOLLOWER_H_

#include <coppice_msgs/Sightings.h>
#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/pose2d.h"
#include "robot_app/perception/clouds/people_finder.h"
#include "robot_app/perception/legs/leg_finder.h"
#include "robot_app/perception/tracking/tracker.h"

namespace coppice::robot::perception {

struct FollowerOptions {
  std::string frame = "odom";      ///< in which people are followed; it must not move
  double least_probability = 0.5;  ///< from which a cluster is a person
  double farthest = 20;            ///< people are looked for so far in clouds [m]
};

/// How people look in clouds, and their legs in scans of the laser. Movable.
struct Classifiers {
  /// Reads two files of `coppice-train`.
  static Expected<Classifiers> Load(const std::string& clouds_file, const std::string& legs_file);

  PersonClassifier clouds;
  LegClassifier legs;
};

/// One thread. The stamps of messages are of now (robot_app/common/transforms/message_time.h).
class PeopleFollower {
 public:
  /// As Transforms::Find.
  using FindTransform = std::function<Expected<geometry_msgs::TransformStamped>(
      const std::string& parent, const std::string& child, const ros::Time& time)>;

  PeopleFollower(const FollowerOptions& options, Classifiers classifiers,
                 FindTransform find_transform);

  /// A turn of the lidar. A problem says what is wrong with it; then nothing has changed.
  Outcome OnCloud(const sensor_msgs::PointCloud2& message);

  /// What is seen in a picture. Returns how late it comes [s]: later than kMostDelay it is left
  /// out. A problem as above.
  Expected<double> OnSightings(const coppice_msgs::Sightings& message);

  /// A scan of the planar laser. True if it was looked at; it is if there was no cloud for half a
  /// second. A problem as above.
  Expected<bool> OnScan(const sensor_msgs::LaserScan& message);

  const Tracker& tracker() const { return tracker_; }
  /// Nothing before the first cloud.
  const std::optional<PeopleFinder>& finder() const { return finder_; }
  /// The lidar at the last cloud: on the floor of the frame, and how high above it [m].
  const Pose2D& lidar() const { return lidar_; }

 private:
  struct Mount {
    Pose2D pose;
    double height = 0;
  };
  // Where a camera surely sees people.
  struct View {
    double time = 0;
    Pose2D lens;
    double half_angle = 0;
    double farthest = 0;
  };

  Expected<Mount> MountAt(const std::string& lidar, const ros::Time& time) const;
  PeopleFinder& FinderAt(double height);
  void Update(double time, const std::vector<Detection>& detections);
  bool IsLidarAlive(double time) const;
  bool IsInPicture(const Eigen::Vector2d& at) const;
  bool IsInScan(const Eigen::Vector2d& at) const;
  bool IsOutOfSight(const Eigen::Vector2d& at) const;

  FollowerOptions options_;
  PersonClassifier classifier_;  // until the finder has it
  FindTransform find_transform_;
  std::optional<PeopleFinder> finder_;  // once the height of the lidar is known
  Tracker tracker_;
  std::vector<LidarPoint> points_;
  Pose2D lidar_;
  double cloud_time_ = -1e9;           // of the last cloud
  std::map<std::string, View> views_;  // of the cameras, by name
  LegFinder leg_finder_;
  LaserScan scan_;            // that was looked at last
  Pose2D laser_;              // at that time
  double first_scan_ = -1e9;  // a robot that starts may hear the laser before the lidar
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_FOLLOWER_H_
