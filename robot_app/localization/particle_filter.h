// Monte Carlo localization: the belief about the pose as a cloud of weighted poses.
//
// S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics (2005): sampled odometry motion (ch. 5.4),
// likelihood field (6.4), low variance resampling (4.3), a number of particles by KLD sampling
// (8.3.7), and the averages of the likelihood that tell a kidnapped robot (augmented MCL, 8.3.5).
// Fresh particles are drawn at places that a search has found, not anywhere (S. Lenser, M. Veloso:
// Sensor Resetting Localization for Poorly Modelled Mobile Robots, ICRA 2000).
//
// Deterministic for one seed; without a clock, a thread or ROS. Poses of base_link in the map.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_PARTICLE_FILTER_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_PARTICLE_FILTER_H_

#include <cstdint>
#include <random>
#include <vector>

#include "robot_app/localization/place_search.h"

namespace coppice::robot::localization {

struct ParticleFilterSettings {
  int fewest = 300;
  int most = 3000;
  int beams = 60;             ///< of a scan that are used
  double end_noise = 0.1;     ///< of a beam's end, with the errors of the map [m]
  double random_share = 0.2;  ///< of beams that end anywhere: people, moved things
  double independent = 12;    ///< beams of one scan tell as much as so many independent ones
  double way_noise = 0.04;    ///< standard deviation of the odometry for each metre [m]
  double turn_noise = 0.04;   ///< for each radian [rad]
  double drift = 0.02;        ///< of the yaw for each metre, of the way for each radian
  double slow = 0.02;         ///< share of the newest likelihood in the slow average
  double fast = 0.2;          ///< and in the fast one
};

/// The heaviest group of particles.
struct Belief {
  Pose2D pose;
  double variance_x = 0, variance_y = 0, covariance_xy = 0;  ///< [m^2]
  double variance_yaw = 0;                                   ///< [rad^2]
  double share = 0;  ///< of the weight of all particles, 0..1
  /// Standard deviation of the position [m].
  double deviation() const;
};

class ParticleFilter {
 public:
  explicit ParticleFilter(ParticleFilterSettings settings = {}, std::uint64_t seed = 1)
      : settings_(settings), random_(seed) {}

  bool empty() const { return particles_.empty(); }
  std::size_t size() const { return particles_.size(); }

  /// Forgets everything: a normal distribution about `pose`.
  void Set(const Pose2D& pose, double deviation, double yaw_deviation);
  /// Adds fresh particles near the places, more of them at those that fit better. Together they
  /// get this share of the weight. The next Weigh() brings the number down again.
  void Inject(const std::vector<FittingPlace>& places, double share);
  /// Adds noise to all of them: the robot may have moved unseen.
  void Spread(double deviation, double yaw_deviation);

  /// The robot moved by `motion`, as seen from where it was.
  void Move(const Pose2D& motion);
  /// Weighs the particles by the scan, and resamples when few of them carry the weight.
  void Weigh(const LikelihoodField& field, const std::vector<Beam>& beams);

  /// Augmented MCL: this share of the particles should be drawn anew, because the scans of late fit
  /// worse than those before.
  double FreshShare() const;
  Belief belief() const;

 private:
  struct Particle {
    Pose2D pose;
    double weight = 0;
  };
  double Normal(double deviation) { return deviation * normal_(random_); }
  Pose2D Near(const Pose2D& pose, double deviation, double yaw_deviation);
  void Normalize();
  void Resample();
  std::size_t Needed(std::size_t bins) const;

  ParticleFilterSettings settings_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0, 1};
  std::vector<Particle> particles_;
  double slow_ = 0;
  double fast_ = 0;
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_PARTICLE_FILTER_H_
