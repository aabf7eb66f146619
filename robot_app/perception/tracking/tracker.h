// Follows people over time: what several sensors see now and then becomes somebody with a number, a
// place and a velocity.
//
//   Tracker tracker;
//   tracker.Update(stamp, detections, [&](const Eigen::Vector2d& at) { return IsHidden(at); });
//   for (const Track& track : tracker.tracks()) if (track.is_confirmed) ...
//
// Positions are in a frame that does not move with the robot (`odom` or `map`), metres and seconds.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_TRACKING_TRACKER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_TRACKING_TRACKER_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace coppice::robot::perception {

enum class Modality : std::uint8_t { kLidar = 1, kCamera = 2, kLaser = 4 };
inline constexpr std::array<Modality, 3> kModalities{Modality::kLidar, Modality::kCamera,
                                                     Modality::kLaser};

/// Somebody seen at one moment by one sensor.
struct Detection {
  Eigen::Vector2d position{0, 0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  double probability = 1;  ///< that it is a person, 0..1
  Modality modality = Modality::kLidar;
  std::optional<bool> has_mask;  ///< if the face was seen
};

/// How much later than `time` of the tracker a sensor may tell of it [s].
inline constexpr double kMostDelay = 1;

struct Track {
  std::uint32_t id = 0;               ///< never used again
  Eigen::Vector4d state{0, 0, 0, 0};  ///< x, y, their velocities
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
  bool is_confirmed = false;
  double first_seen = 0;         ///< [s]
  double last_seen = 0;          ///< [s]
  std::uint8_t modalities = 0;   ///< bits of Modality: who has seen the person within a second
  std::optional<bool> has_mask;  ///< once two more faces told so than told the opposite

  Eigen::Vector2d position() const { return state.head<2>(); }
  Eigen::Vector2d velocity() const { return state.tail<2>(); }

  // For the tracker: how sure it is that there is somebody, as the logarithm of the odds; when each
  // sensor saw the person last; faces with mask less faces without.
  double evidence = 0;
  std::array<double, kModalities.size()> seen_by{-1e9, -1e9, -1e9};
  int mask_votes = 0;
};

struct TrackerOptions {
  double acceleration = 2.2;  ///< of people, standard deviation [m/s^2]
  double start_speed = 1.2;   ///< standard deviation of a velocity not yet known [m/s]
  double gate = 13.8;         ///< square of the Mahalanobis distance; 99.9 % of the right ones
  double confirmed = 5;       ///< evidence from which a track is somebody
  double forgotten = 2;       ///< gone after so many seconds unseen in plain view,
  double hidden = 6;          ///< after so many while something stands before,
  double tentative = 0.35;    ///< and after so many if it never was confirmed,
  double tentative_in_pictures = 1.2;  ///< or if only cameras saw it, who look less often
};

class Tracker {
 public:
  explicit Tracker(const TrackerOptions& options = {}) : options_(options) {}

  /// Whether the sensors cannot see that place now because something stands before.
  using IsHidden = std::function<bool(const Eigen::Vector2d&)>;

  /// Takes what one sensor saw at `time`, people of one moment all at once. What is told late, as
  /// of a picture that took long to look at, counts for where people were at that time; later than
  /// kMostDelay it is ignored. Time that runs backwards by more than five seconds (a record played
  /// again) begins anew.
  void Update(double time, const std::vector<Detection>& detections, const IsHidden& is_hidden);

  /// Everybody who is followed, oldest first.
  const std::vector<Track>& tracks() const { return tracks_; }
  double time() const { return time_; }  ///< of the last update

 private:
  void Predict(double dt);
  std::vector<int> Match(const std::vector<Detection>& detections, double age) const;
  void Correct(Track& track, const Detection& detection, double age) const;
  void Begin(const Detection& detection, double age);
  bool IsGone(const Track& track, const IsHidden& is_hidden) const;

  TrackerOptions options_;
  std::vector<Track> tracks_;
  double time_ = -1e9;
  std::uint32_t next_id_ = 1;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_TRACKING_TRACKER_H_
