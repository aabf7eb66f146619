// People who walk through the floor on their rounds, or behind the robot.
#ifndef COPPICE_ROBOT_APP_SIMULATION_PEOPLE_H_
#define COPPICE_ROBOT_APP_SIMULATION_PEOPLE_H_

#include <vector>

#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/scene/figure.h"
#include "robot_app/simulation/scene/ray_caster.h"

namespace coppice::robot::simulation {

inline constexpr double kPersonRadius = 0.25;    ///< m
inline constexpr double kPersonDistance = 0.6;   ///< m, kept from the robot's edge when walking
inline constexpr double kPersonPatience = 4;     ///< s of waiting, then the person turns round
inline constexpr double kPersonHesitates = 1.5;  ///< s of waiting, then the person steps aside
inline constexpr double kFollowsAt = 1;          ///< m, from the robot's edge to who follows it
inline constexpr double kPersonSqueezes = 0.25;  ///< m, kept from the robot's edge when doing that

/// Everybody walks from waypoint to waypoint, stops before the robot and before walls, closed doors
/// and boxes, and turns round after a while of waiting; who steps aside goes round a robot that
/// stands still, nearer than is polite. People make way for each other without our help.
class People {
 public:
  /// Everybody stands at the first point of the own path.
  explicit People(std::vector<Walker> walkers);

  /// Lets `dt` seconds pass, with the robot's disc where it is and what stands still in `still`.
  void Step(double dt, const Disc& robot, const RayCaster& still);

  /// Has somebody walk behind the robot, the way that it takes, straight to it where he sees it.
  /// Who no longer does walks back the way that he has come, and goes on with his round.
  void SetFollows(std::size_t person, bool follows) { states_[person].follows = follows; }

  /// In the order of the floor.
  const std::vector<Disc>& discs() const { return discs_; }
  /// How everybody stands or walks, in the same order.
  std::vector<Stance> Stances() const;

 private:
  struct State {
    std::size_t target = 0;    // point of the path
    bool forward = true;       // through the path
    double left = 1e9;         // to the target, at the nearest so far [m]
    double waited = 0;         // without coming nearer to it [s]
    double walked = 0;         // m
    double heading = 0;        // rad
    bool follows = false;      // the robot
    std::vector<Vec2> ahead;   // the way that it has taken, up to where it is
    std::vector<Vec2> behind;  // his own, since he left his round
    int aside = 0;             // goes round the robot: 1 to the left of the way, -1 to the right
  };
  bool Step(std::size_t i, Vec2 direction, double step, const Disc& robot, const RayCaster& still);
  bool StepAside(std::size_t i, Vec2 direction, double step, const Disc& robot,
                 const RayCaster& still);
  void ComesNearer(std::size_t i);
  void Walk(std::size_t i, double dt, const Disc& robot, const RayCaster& still);
  void Advance(std::size_t i);
  bool IsFree(std::size_t i, Vec2 point, const RayCaster& still) const;
  void Follow(std::size_t i, double dt, const Disc& robot, const RayCaster& still);
  void WalkBack(std::size_t i, double dt, const Disc& robot, const RayCaster& still);
  bool StepTo(std::size_t i, Vec2 point, double dt, const Disc& robot, const RayCaster& still);

  std::vector<Walker> walkers_;
  std::vector<State> states_;
  std::vector<Disc> discs_;
  Vec2 robot_;              // where it is
  double robot_stood_ = 0;  // there, so long [s]
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_PEOPLE_H_
