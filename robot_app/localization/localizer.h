// Where the robot is on the map, and whether that can be trusted.
//
// A particle filter follows the robot. Every scan is compared with the map at the estimated pose.
// The pose is *confirmed* (that is our loop closure) while
//   - the scan agrees with the map there,
//   - the particles are together, and
//   - the place is proven: nothing else on the map fits as well as it does.
// A place is proven by a person who sets it, by a start where the robot was expected, or by looking
// around (a full turn on the spot) if then exactly one place on the map fits. Every few seconds the
// whole map is searched for a place that fits better: a corridor looks alike along its whole
// length, and a robot that was carried along it would not notice otherwise. When much of what the
// scanner sees changes at once while the odometry knows of no motion, that is suspicious, and less
// is needed to doubt. A hint of somebody who recognizes places, as by pictures, is believed if the
// scan fits there: it proves one of several places that fit equally well. Not confirmed for a
// while: UNCERTAIN, then LOST. Where several places fit equally it says so and stays UNCERTAIN,
// until the robot has seen more or a person helps; it never picks one.
//
// Deterministic, without a clock, a thread or ROS. Stamps in seconds of any one clock.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_LOCALIZER_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_LOCALIZER_H_

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/localization/local_view.h"
#include "robot_app/localization/particle_filter.h"
#include "robot_app/localization/pose_history.h"
#include "robot_app/localization/scan_change.h"

namespace coppice::robot::localization {

struct LocalizerSettings {
  ParticleFilterSettings filter;
  std::uint64_t seed = 1;
  double agree = 0.65;             ///< the scan agrees with the map from this score on
  double margin = 0.06;            ///< a rival: so much smaller a share of the beams agrees there
  double largest_deviation = 0.3;  ///< of a confirmed position [m]
  double uncertain_after = 1.5;    ///< not confirmed for so long [s]
  double lost_after = 5;           ///< s
  double search_period = 2;        ///< while not confirmed [s]
  double check_period = 3;         ///< for better places, while confirmed [s]
};

enum class LocalizationPhase : std::uint8_t { kOk, kUncertain, kLost };

struct LocalizationReport {
  LocalizationPhase phase = LocalizationPhase::kUncertain;
  double seconds_since_confirmed = 0;
  double score = 0;      ///< of the last scan at the estimated pose, 0..1
  double deviation = 0;  ///< standard deviation of the position; infinite if there is none [m]
  double seconds_since_recognized = 0;  ///< that was believed; infinite: never
  std::string message;                  ///< for people
};

class Localizer {
 public:
  explicit Localizer(LocalizerSettings settings = {});
  ~Localizer();

  /// Builds what is derived from the map (some 50 ms) and starts anew.
  void SetMap(const OccupancyGrid& map);

  /// Where the robot may be at the start: the charging station, the last pose before the restart.
  /// Taken, in this order, only if the first scan agrees there (or up to 2 m beside it) and no
  /// place on the map fits better. Without one that holds, the whole map is searched. A start is
  /// also when time is set back by more than a second.
  void Expect(const std::vector<Pose2D>& poses) { expected_ = starts_ = poses; }

  /// A person says where the robot is, at about this deviation [m], [rad]. Believed, but it still
  /// has to agree with the scan to be confirmed.
  void SetPose(const Pose2D& pose, double deviation, double yaw_deviation);

  /// Forgets where the robot is and searches the whole map.
  void Relocalize();

  /// Somebody recognizes a place: base_link was at about `pose` (to half a metre and 10 degrees) at
  /// `stamp`, at most 5 s ago. Believed only if the next scan fits there as well as anywhere, with
  /// all that was seen since the robot looks around. While the robot is sure to be elsewhere, two
  /// hints from different views are needed. What is older than a doubt that the robot was carried
  /// away is not used.
  void AddHint(double stamp, const Pose2D& pose);

  /// base_link in the odometry frame. If the frame itself has jumped (its source was restarted) the
  /// robot is believed to stand about where it stood before.
  void AddOdometry(double stamp, const Pose2D& pose);
  /// A scan is used once odometry is known for its time; a newer one replaces a waiting one.
  void AddScan(LaserScan scan);

  /// Nothing as long as there is no idea at all.
  std::optional<Pose2D> pose() const;
  /// The pose of the odometry frame in the map; with the odometry of scan_stamp() it gives pose().
  Pose2D odom_in_map() const { return Compose(pose_, RelativeTo(odometry_, Pose2D{})); }
  /// Of the last scan that was used.
  double scan_stamp() const { return stamp_; }
  const Belief& belief() const { return belief_; }
  std::size_t particles() const { return filter_.size(); }
  LocalizationReport Report(double now) const;

 private:
  static constexpr double kHintsUpTo = 5;  // s, old
  struct Map;
  struct Hint {
    Pose2D odom_in_map;
    Pose2D odometry;  // of base_link when it was seen
    int frame = 0;    // of the history
  };
  void Process(const LaserScan& scan, const Pose2D& odometry);
  void Begin(double stamp);
  void Doubt();
  void Advance(const Pose2D& odometry);
  void Start(const std::vector<Beam>& beams);
  void Follow(const std::vector<Beam>& beams);
  void Judge(const std::vector<Beam>& beams);
  void LookAround(const std::vector<Beam>& beams);
  void LookForBetter(const std::vector<Beam>& beams);
  bool IsBetterElsewhere(const std::vector<Beam>& beams);
  bool FitsBetterElsewhere(const std::vector<Beam>& beams, int through, double clearly) const;
  bool TakeHint(const std::vector<Beam>& beams);
  bool FitsAsWellAsAnywhere(const std::vector<Beam>& beams, const Pose2D& pose) const;
  bool IsOfOtherView(const Hint& hint) const;
  bool IsOfSamePlace(const Hint& hint) const;
  void Consider(const std::vector<FittingPlace>& places);
  void PutAt(const Pose2D& pose, bool proven);

  LocalizerSettings settings_;
  std::unique_ptr<Map> map_;
  ParticleFilter filter_;
  PoseHistory history_{kHintsUpTo};
  std::optional<LaserScan> waiting_;
  LocalView view_;
  ScanChange change_;
  std::vector<Pose2D> starts_;
  std::vector<Pose2D> expected_;  // empty once a scan has been used

  bool begun_ = false;  // a scan has been used
  double stamp_ = 0;
  int frame_ = 0;       // of the history, at stamp_
  Pose2D odometry_;     // at stamp_
  Pose2D pose_;         // at stamp_
  Pose2D filter_lag_;   // motion that the filter was not told yet
  double weighed_ = 0;  // stamp of the last scan that the filter weighed
  Belief belief_;       // at the time of weighed_
  Agreement agreement_;
  bool fits_ = false;  // the last scan, and the particles are together
  bool proven_ = false;
  bool jumped_ = false;  // since it was proven
  bool lost_ = false;
  bool doubted_ = false;    // it looked as if somebody carried the robot away
  int contested_ = 0;       // searches that found a better place, since it was settled
  int uncontested_ = 0;     // searches in a row that found none
  std::size_t rivals_ = 0;  // places that fit as well as the best one
  double confirmed_ = 0;
  bool looking_ = false;  // around, for what to make of this place
  double view_since_ = 0;
  double next_search_ = 0;
  std::optional<Hint> hint_;       // waits for the next scan
  std::optional<Hint> elsewhere_;  // fits, though the robot is sure to be somewhere else
  double recognized_ = -std::numeric_limits<double>::infinity();  // when one was believed
  double doubted_at_ = -std::numeric_limits<double>::infinity();  // hints before do not count
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_LOCALIZER_H_
