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
// what it has driven, and turned as it may be: rooms that are built alike look alike to a lidar.
//
// With a store all is on the disk after each sight, and what is not worked with is only there.
//
// Frames (REP-105): odometry is base_link in odom. Not thread-safe.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAPPER_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAPPER_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/slam/clouds/cloud_places.h"
#include "robot_app/slam/map/environment.h"
#include "robot_app/slam/map/map_store.h"
#include "robot_app/slam/map/memory.h"
#include "robot_app/slam/map/sight.h"
#include "robot_app/slam/map/slam_map.h"
#include "robot_app/slam/pictures/picture_places.h"

namespace coppice::robot::slam {

struct MapperSettings {
  double step = 0.5;                    ///< a key frame after so much way [m]
  double turn = 0.35;                   ///< or after such a turn [rad]
  std::size_t working = 2000;           ///< key frames that are asked for places, and in memory
  std::size_t recent = 12;              ///< the last ones are not asked for: they are bound anyway
  double drift = 0.03;                  ///< how far odometry may be off, share of the way,
  double twist = 0.006;                 ///< and turned too far, for each metre [rad]
  Eigen::Vector3d lidar = {0, 0, 1.2};  ///< in base_link
  double resolution = 0.1;              ///< of the voxels [m]
  SessionGraphSettings graph;
  PicturePlacesSettings pictures;
  CloudPlacesSettings clouds;
  EnvironmentSettings environment;
};

/// A known place that pictures show.
struct KnownPlace {
  std::uint32_t key_frame = 0;
  Pose3 relative = Pose3::Identity();  ///< base_link as seen from the key frame's
};

/// What came of a sight.
struct MapperReport {
  std::uint32_t key_frame = 0;
  std::optional<Link> by_picture, by_cloud;  ///< closures that were sure
  Verdict of_picture = Verdict::kRefused, of_cloud = Verdict::kRefused;
  SolverWork work;      ///< of the pose graph
  std::string problem;  ///< of the long-term memory; empty: none
};

class SlamMapper {
 public:
  /// Vocabulary and classifier must outlive it. Without a store all stays in memory.
  SlamMapper(const Vocabulary& vocabulary, const PlaceClassifier& classifier,
             MapperSettings settings = {}, std::unique_ptr<MapStore> store = nullptr);

  /// Goes on with a map; before any session has begun. Key frames that are null are in the store;
  /// if none is, all go there. A problem: they cannot be written or read.
  Outcome Resume(SlamMap map);

  /// The robot may be anywhere. Odometry begins anew.
  void BeginSession(const std::string& name);

  /// Whether it is far enough from the last key frame for another one.
  bool IsDue(const Pose3& odometry) const;

  /// Keeps a key frame and looks where it was taken.
  MapperReport Add(const Sight& sight);

  /// The localization has become sure since: base_link of the newest key frame (Sight::place).
  Outcome PlaceNewest(const Pose2D& place);

  /// The key frame of the working memory that the pictures show, if one is sure; nothing is kept.
  /// The newest key frames of this session are not asked for. About 30 ms for each picture.
  std::optional<KnownPlace> Recognize(const std::vector<SightPicture>& pictures);

  /// base_link in the frame of the session's map.
  Pose3 PoseOf(const Pose3& odometry) const;

  /// Whether this session lies in the map of an older one, or is the first.
  bool IsJoined() const;

  /// Everything, to be saved. Key frames are shared, not copied; those of the long-term memory are
  /// null, and in the store.
  SlamMap Map() const;
  const SessionGraph& graph() const { return graph_; }
  /// Of each pose; null: it is not in the working memory.
  const std::vector<std::shared_ptr<const KeyFrame>>& key_frames() const { return key_frames_; }
  /// Of one pose, wherever it is kept.
  Expected<std::shared_ptr<const KeyFrame>> key_frame(std::uint32_t pose) const;
  MapStore* store() const { return store_.get(); }
  const Memory& memory() const { return memory_; }
  Environment& environment() { return environment_; }
  /// Metres since the last closure that was believed.
  double way_since_closure() const { return way_ - closed_at_; }

 private:
  void Remember(std::uint32_t key_frame, KnownCloud cloud);
  void RememberAgain(std::uint32_t key_frame);
  Outcome Apply(const MemoryChange& change);
  MemoryChange Use(const std::vector<std::uint32_t>& near);
  std::uint64_t PlaceOf(std::uint32_t key_frame) const;
  void LookAtPictures(const Sight& sight, MapperReport& report);
  void LookAtCloud(const KnownCloud& cloud, MapperReport& report);
  Verdict Close(const Link& link);
  std::vector<std::uint32_t> Near(double radius) const;
  bool IsOld(std::uint32_t key_frame) const;

  const MapperSettings settings_;
  const std::unique_ptr<MapStore> store_;
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

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAPPER_H_
