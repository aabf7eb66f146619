// All turns of the lidar that were kept, and the question where a new one was measured: a
// classifier of pairs finds candidates, registration decides.
//
// K. Granstrom et al. (see cloud_descriptor.h); T.-L. Habich, M. Stuede, M. Labbe, S.
// Spindeldreier: Have I been here before? Learning to Close the Loop with LiDAR Data in Graph-Based
// SLAM, AIM 2021: candidates by the classifier, then registration in steps, refused when it does
// not fit.
#ifndef COPPICE_ROBOT_APP_SLAM_CLOUDS_CLOUD_PLACES_H_
#define COPPICE_ROBOT_APP_SLAM_CLOUDS_CLOUD_PLACES_H_

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "robot_app/common/learning/classifier.h"
#include "robot_app/slam/clouds/cloud_descriptor.h"
#include "robot_app/slam/clouds/registration.h"

namespace coppice::robot::slam {

struct PlaceKind {
  using Features = PairFeatures;
  static constexpr BoostedTrees::Subject kSubject{"place_classifier",
                                                  static_cast<int>(kPairFeatures), "places"};
};

/// One of the kind: two clouds that were measured at one place, by what Compare() says of them;
/// learnt by `coppice-train places`.
using PlaceClassifier = Classifier<PlaceKind>;

/// A turn as it is kept.
struct KnownCloud {
  CloudDescriptor descriptor;
  ThinCloud thin;
};
KnownCloud Keep(const CloudPoints& points, double range = 40);

struct CloudPlace {
  std::uint32_t key_frame = 0;
  float probability = 0;  ///< of the classifier
  Registration registration;
};

/// How the robot may be turned, as seen from a key frame, before any cloud is looked at: no place
/// is believed that is turned otherwise. Rooms look alike from several sides.
struct TurnGuess {
  double turn = 0;      ///< [rad]
  double doubt = M_PI;  ///< [rad]
};
/// Nothing: that key frame is not asked for.
using CloudQuestion = std::function<std::optional<TurnGuess>(std::uint32_t)>;

struct CloudPlacesSettings {
  std::size_t compared = 60;   ///< the clouds of the likest scalars, which the classifier looks at
  std::size_t candidates = 2;  ///< that are registered
  std::size_t turns = 2;       ///< that each candidate is tried with
  float least_probability = 0.5F;
  RegistrationSettings registration;
};

/// Not thread-safe. The classifier must outlive it.
class CloudPlaces {
 public:
  explicit CloudPlaces(const PlaceClassifier& classifier, CloudPlacesSettings settings = {})
      : classifier_(classifier), settings_(settings) {}

  void Add(std::uint32_t key_frame, KnownCloud cloud);

  /// Takes the clouds of a key frame out again.
  void Remove(std::uint32_t key_frame);

  /// A key frame that the cloud surely lies upon (IsSure), the likest first; else the one that it
  /// lies upon best; of those that are asked for, and turned as it may be. Nothing: the classifier
  /// knows none, or none can be registered. At most `candidates` times `turns` registrations, and
  /// one for each candidate if the turn is known well.
  std::optional<CloudPlace> Find(const KnownCloud& cloud, const CloudQuestion& question) const;

  const CloudPlacesSettings& settings() const { return settings_; }

 private:
  struct Candidate {
    std::size_t cloud = 0;
    TurnGuess guess;
    float probability = 0;
  };
  std::vector<Candidate> Candidates(const KnownCloud& cloud, const CloudQuestion& question) const;
  std::vector<double> Turns(const Candidate& candidate, const KnownCloud& cloud) const;

  const PlaceClassifier& classifier_;
  CloudPlacesSettings settings_;
  // Of each cloud.
  std::vector<KnownCloud> clouds_;
  std::vector<std::uint32_t> key_frames_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_CLOUDS_CLOUD_PLACES_H_
