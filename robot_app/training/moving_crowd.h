// People who walk about, stop, meet and hide behind each other, for the test of who is followed.
#ifndef COPPICE_ROBOT_APP_TRAINING_MOVING_CROWD_H_
#define COPPICE_ROBOT_APP_TRAINING_MOVING_CROWD_H_

#include <random>
#include <vector>

#include "robot_app/training/random_hall.h"

namespace coppice::robot::training {

class MovingCrowd {
 public:
  /// `count` people anywhere free on the site, none within `keep_off` metres of `robot`.
  MovingCrowd(const Site& site, int count, simulation::Vec2 robot, double keep_off,
              std::uint64_t seed);

  /// Everybody walks on: to places drawn at random, where some wait, some beside somebody else.
  /// Nobody walks through things or people; who is in the way of another goes round or waits.
  void Step(double dt);

  /// In the order of their numbers.
  const std::vector<simulation::Stance>& people() const { return people_; }

 private:
  struct Intent {
    simulation::Vec2 target;
    double speed = 1;  // m/s
    simulation::Vec2 velocity;
    double waits = 0;     // s left
    double patience = 0;  // s without a step
  };
  bool CanStand(simulation::Vec2 at, std::size_t who) const;
  void Choose(std::size_t who);
  bool Push(std::size_t who, simulation::Vec2 wanted, double dt);
  void Walk(std::size_t who, double dt);

  const Site& site_;
  simulation::Vec2 robot_;
  double keep_off_;
  std::mt19937_64 random_;
  std::vector<simulation::Stance> people_;
  std::vector<Intent> intents_;
};

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_MOVING_CROWD_H_
