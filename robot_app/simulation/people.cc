#include "robot_app/simulation/people.h"

#include <utility>

namespace coppice::robot::simulation {
namespace {

constexpr double kWallDistance = 0.1;  // from the person's edge

// Walking on would bring the person nearer to the robot than is polite.
bool RobotInTheWay(const Disc& robot, Vec2 here, Vec2 there) {
  const double gap = Length(there - robot.center) - robot.radius - kPersonRadius;
  return gap < kPersonDistance && Length(there - robot.center) < Length(here - robot.center);
}

}  // namespace

People::People(std::vector<Walker> walkers) : walkers_(std::move(walkers)) {
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    discs_.push_back({walkers_[i].path.front(), kPersonRadius});
    states_.push_back({});
    Advance(i);
  }
}

void People::Advance(std::size_t i) {
  const std::size_t count = walkers_[i].path.size();
  State& state = states_[i];
  state.target = (state.target + (state.forward ? 1 : count - 1)) % count;
  state.waited = 0;
}

void People::Walk(std::size_t i, double dt, const Disc& robot, const RayCaster& still) {
  Vec2& here = discs_[i].center;
  const Vec2 way = walkers_[i].path[states_[i].target] - here;
  const double left = Length(way);
  const double step = walkers_[i].speed * dt;
  if (left <= step) return Advance(i);
  const Vec2 direction = way * (1 / left);
  states_[i].heading = std::atan2(direction.y, direction.x);
  const Vec2 there = here + direction * step;
  const double reach = kPersonRadius + kWallDistance + step;
  if (!RobotInTheWay(robot, here, there) && still.Cast(here, direction, reach) >= reach) {
    here = there;
    states_[i].walked += step;
    states_[i].waited = 0;
    return;
  }
  states_[i].waited += dt;
  if (states_[i].waited < kPersonPatience) return;
  states_[i].forward = !states_[i].forward;
  Advance(i);
}

void People::Step(double dt, const Disc& robot, const RayCaster& still) {
  for (std::size_t i = 0; i < discs_.size(); ++i) Walk(i, dt, robot, still);
}

std::vector<Stance> People::Stances() const {
  std::vector<Stance> stances(discs_.size());
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    stances[i].position = discs_[i].center;
    stances[i].heading = states_[i].heading;
    stances[i].walked = states_[i].walked;
    stances[i].walks = states_[i].waited <= 0;
    stances[i].height = walkers_[i].height;
  }
  return stances;
}

}  // namespace coppice::robot::simulation
