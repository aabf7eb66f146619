// Makes a map in three dimensions over many sessions, and knows where the robot is on it: key
// frames over odometry, closures by pictures and by clouds, a pose graph.
//
//   SlamMapper mapper(vocabulary, classifier, settings);
//   mapper.BeginSession("monday");
//   if (mapper.IsDue(odometry)) mapper.Add(sight);        // for what the sensors see
//   mapper.PoseOf(odometry);                              // base_link in the map
//
// A session begins in a frame of its own, and is moved into the map of the older ones once two
// closures agree (session_graph.h). Clouds are asked for a place only where the robot may be after
// what it has driven: rooms that are built alike look alike to a lidar.
//
// Frames (REP-105): odometry is base_link in odom. Not thread-safe.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAPPER_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAPPER_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/slam/clouds/cloud_places.h"
#include "robot_app/slam/map/environment.h"
#include "robot_app/slam/map/memory.h"
#include "robot_app/slam/map/slam_map.h"
#include "robot_app/slam/occupancy/voxel_map.h"
#include "robot_app/slam/pictures/picture_places.h"

namespace coppice::robot::slam {

/// What a camera saw. Its points and its place on the robot are given in base_link as that was at
/// the instant of the sight, also if the picture was taken a little before or after.
struct SightPicture {
  PictureFeatures features;
  CameraMount camera;
};

/// What the sensors see at one instant.
struct Sight {
  double stamp = 0;
  Pose3 odometry = Pose3::Identity();
  std::vector<SightPicture> pictures;
  double brightness = 1;  ///< of the pictures, 0..1
  CloudPoints cloud;      ///< in base_link
};

struct MapperSettings {
  double step = 0.5;                    ///< a key frame after so much way [m]
  double turn = 0.35;                   ///< or after such a turn [rad]
  std::size_t working = 2000;           ///< key frames that are asked for places
  std::size_t recent = 12;              ///< the last ones are not asked for: they are bound anyway
  double drift = 0.03;                  ///< how far odometry may be off, share of the way
  Eigen::Vector3d lidar = {0, 0, 1.2};  ///< in base_link
  double resolution = 0.1;              ///< of the voxels [m]
  SessionGraphSettings graph;
  PicturePlacesSettings pictures;
  CloudPlacesSettings clouds;
  EnvironmentSettings environment;
};

/// What came of a sight.
struct MapperReport {
  std::uint32_t key_frame = 0;
  std::optional<Link> by_picture, by_cloud;  ///< closures that were sure
  Verdict of_picture = Verdict::kRefused, of_cloud = Verdict::kRefused;
};

class SlamMapper {
 public:
  /// Vocabulary and classifier must outlive it.
  SlamMapper(const Vocabulary& vocabulary, const PlaceClassifier& classifier,
             MapperSettings settings = {});

  /// Goes on with a map that was saved; before any session has begun.
  void Resume(SlamMap map);

  /// The robot may be anywhere. Odometry begins anew.
  void BeginSession(const std::string& name);

  /// Whether it is far enough from the last key frame for another one.
  bool IsDue(const Pose3& odometry) const;

  /// Keeps a key frame and looks where it was taken.
  MapperReport Add(const Sight& sight);

  /// base_link in the frame of the session's map.
  Pose3 PoseOf(const Pose3& odometry) const;

  /// Whether this session lies in the map of an older one, or is the first.
  bool IsJoined() const;

  /// Everything, to be saved. Key frames are shared, not copied.
  SlamMap Map() const;
  const SessionGraph& graph() const { return graph_; }
  const std::vector<std::shared_ptr<const KeyFrame>>& key_frames() const { return key_frames_; }
  const Memory& memory() const { return memory_; }
  Environment& environment() { return environment_; }
  /// Metres since the last closure that was believed.
  double way_since_closure() const { return way_ - closed_at_; }

 private:
  void Remember(std::uint32_t key_frame);
  void Apply(const MemoryChange& change);
  void LookAtPictures(const Sight& sight, MapperReport& report);
  void LookAtCloud(const KnownCloud& cloud, MapperReport& report);
  Verdict Close(const Link& link);
  std::vector<std::uint32_t> Near(double radius) const;
  bool IsOld(std::uint32_t key_frame) const;

  const MapperSettings settings_;
  SessionGraph graph_;
  PicturePlaces pictures_;
  CloudPlaces clouds_;
  Memory memory_;
  Environment environment_;
  std::vector<std::shared_ptr<const KeyFrame>> key_frames_;
  std::vector<SessionName> names_;
  bool is_first_ = true;                    // of its session
  std::uint32_t session_begin_ = 0;         // key frame
  Pose3 at_key_frame_ = Pose3::Identity();  // odometry
  double way_ = 0;
  double closed_at_ = 0;
};

/// The voxels of all key frames that lie in the map of session `map`.
VoxelMap VoxelsOf(const SlamMap& map, std::uint32_t of_session, const Eigen::Vector3d& lidar,
                  double resolution);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAPPER_H_
