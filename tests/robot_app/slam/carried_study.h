// Does a robot that stands anywhere find out where that is, by its laser alone and with the places
// that its cameras recognize? In the simulated institute, in simulated time.
#ifndef COPPICE_TESTS_ROBOT_APP_SLAM_CARRIED_STUDY_H_
#define COPPICE_TESTS_ROBOT_APP_SLAM_CARRIED_STUDY_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/slam/map/navigation_frame.h"
#include "robot_app/slam/map/slam_mapper.h"
#include "robot_app/training/slam_tour.h"
#include "tests/robot_app/localization/localized_robot.h"

namespace coppice::robot::slam {

/// A way through the corridor, the hall and all offices of the institute; 170 m.
std::vector<simulation::Vec2> RoundOfAllRooms();

/// The institute with a map in three dimensions that was made on one round in full light.
class KnownInstitute {
 public:
  /// Drives the way; some seconds for each 10 m.
  explicit KnownInstitute(const std::vector<simulation::Vec2>& way);

  const simulation::Floor& floor() const { return floor_; }

  /// Where the pictures of both cameras say that a robot at `truth` stands, in the frame `map`.
  /// People stand around as `moment` says.
  std::optional<Pose2D> Look(const Pose2D& truth, double moment);

  /// For looks: 1 is full light.
  void SetLight(double light);

 private:
  simulation::Floor floor_;
  training::RobotSensors sensors_;
  Vocabulary vocabulary_;
  PlaceClassifier classifier_;
  SlamMapper mapper_;
  std::unique_ptr<training::TourEyes> eyes_;
};

struct CarriedOptions {
  bool with_pictures = true;
  bool carried = true;  ///< else it was started there and nobody has told it where that is
};

/// What came of one place.
struct CarriedOutcome {
  Pose2D place;
  localization::LocalizationPhase phase = localization::LocalizationPhase::kLost;  ///< at the end
  double error = 0;             ///< at the end [m]
  bool lost = false;            ///< it has noticed that it was carried
  bool found_standing = false;  ///< OK before it turned
  double wrong = 0;             ///< so long it called a wrong place OK, since it was lost [s]
  int hints = 0;                ///< places that were recognized in pictures
  int wrong_hints = 0;          ///< more than half a metre off

  bool found() const { return phase == localization::LocalizationPhase::kOk && error < 0.15; }
};

/// Puts the robot there, lets it stand until it is lost (for 5 s if it was started there), and
/// turns it once.
CarriedOutcome PutAt(KnownInstitute& institute, const Pose2D& before, const Pose2D& place,
                     std::uint64_t seed, const CarriedOptions& options);

/// So many places at random. `say` hears how far it is, 0..1.
std::vector<CarriedOutcome> PutAnywhere(KnownInstitute& institute, int places, unsigned seed,
                                        const CarriedOptions& options,
                                        const std::function<void(double)>& say);

std::string TableHead();
std::string TableLine(const std::string& name, const std::vector<CarriedOutcome>& outcomes);

}  // namespace coppice::robot::slam

#endif  // COPPICE_TESTS_ROBOT_APP_SLAM_CARRIED_STUDY_H_
