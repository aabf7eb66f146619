#include "robot_app/simulation/people.h"

#include <utility>

namespace coppice::robot::simulation {
namespace {

constexpr double kWallDistance = 0.1;  // from the person's edge

constexpr double kCrumb = 0.3;         // m, between the points of a way that is remembered
constexpr double kStandsStill = 0.02;  // a robot that has moved less [m]
constexpr double kTurnAside = 20 * kPi / 180;
constexpr int kTurnsAside = 5;  // up to 100 degrees

// Walking on would bring the person nearer to the robot than `least`.
bool RobotInTheWay(const Disc& robot, Vec2 here, Vec2 there, double least) {
  const double gap = Length(there - robot.center) - robot.radius - kPersonRadius;
  return gap < least && Length(there - robot.center) < Length(here - robot.center);
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
  state.left = 1e9;
  state.waited = 0;
}

// False if that is not free.
bool People::Step(std::size_t i, Vec2 direction, double step, const Disc& robot,
                  const RayCaster& still) {
  Vec2& here = discs_[i].center;
  const Vec2 there = here + direction * step;
  const double reach = kPersonRadius + kWallDistance + step;
  const double least = states_[i].aside != 0 ? kPersonSqueezes : kPersonDistance;
  if (RobotInTheWay(robot, here, there, least)) return false;
  if (still.Cast(here, direction, reach) < reach) return false;
  here = there;
  states_[i].heading = std::atan2(direction.y, direction.x);
  states_[i].walked += step;
  return true;
}

// As far from the way as the robot needs, on one side of it; on the other where that is too narrow.
bool People::StepAside(std::size_t i, Vec2 direction, double step, const Disc& robot,
                       const RayCaster& still) {
  int& aside = states_[i].aside;
  if (aside == 0) {
    const Vec2 to = robot.center - discs_[i].center;
    aside = direction.x * to.y - direction.y * to.x > 0 ? -1 : 1;
  }
  for (const int side : {aside, -aside}) {
    for (int turns = 0; turns <= kTurnsAside; ++turns) {
      if (Step(i, Rotated(direction, side * turns * kTurnAside), step, robot, still)) {
        aside = side;
        return true;
      }
    }
  }
  return false;
}

void People::ComesNearer(std::size_t i) {
  State& state = states_[i];
  const double left = Length(walkers_[i].path[state.target] - discs_[i].center);
  if (left >= state.left) return;
  state.left = left;
  state.waited = 0;
}

// On the straight way, for both shoulders.
bool People::IsFree(std::size_t i, Vec2 point, const RayCaster& still) const {
  const Vec2 way = point - discs_[i].center;
  const double left = Length(way);
  if (left <= kCrumb) return true;
  const Vec2 direction = way * (1 / left);
  const Vec2 shoulder = Vec2{-direction.y, direction.x} * (kPersonRadius + kWallDistance);
  const Vec2 here = discs_[i].center;
  return still.Cast(here + shoulder, direction, left) >= left &&
         still.Cast(here - shoulder, direction, left) >= left;
}

// False if something is in the way, or he is there.
bool People::StepTo(std::size_t i, Vec2 point, double dt, const Disc& robot,
                    const RayCaster& still) {
  const Vec2 way = point - discs_[i].center;
  const double left = Length(way);
  const double step = walkers_[i].speed * dt;
  return left > step && Step(i, way * (1 / left), step, robot, still);
}

void People::Follow(std::size_t i, double dt, const Disc& robot, const RayCaster& still) {
  State& state = states_[i];
  const Vec2 here = discs_[i].center;
  if (state.ahead.empty() || Length(robot.center - state.ahead.back()) > kCrumb) {
    state.ahead.push_back(robot.center);
  }
  if (IsFree(i, robot.center, still)) state.ahead = {robot.center};
  while (state.ahead.size() > 1 && Length(state.ahead.front() - here) < kCrumb) {
    state.ahead.erase(state.ahead.begin());
  }
  if (state.behind.empty() || Length(here - state.behind.back()) > kCrumb) {
    state.behind.push_back(here);
  }
  const double gap = Length(robot.center - here) - robot.radius - kPersonRadius;
  const bool walks = gap > kFollowsAt && StepTo(i, state.ahead.front(), dt, robot, still);
  state.waited = walks ? 0 : state.waited + dt;
}

void People::WalkBack(std::size_t i, double dt, const Disc& robot, const RayCaster& still) {
  State& state = states_[i];
  state.ahead.clear();
  const bool walks = StepTo(i, state.behind.back(), dt, robot, still);
  state.waited = walks ? 0 : state.waited + dt;
  if (Length(state.behind.back() - discs_[i].center) >= kCrumb && state.waited < kPersonPatience) {
    return;
  }
  state.behind.pop_back();
  state.waited = 0;
  state.left = 1e9;
}

void People::Walk(std::size_t i, double dt, const Disc& robot, const RayCaster& still) {
  if (states_[i].follows) return Follow(i, dt, robot, still);
  if (!states_[i].behind.empty()) return WalkBack(i, dt, robot, still);
  const Vec2 here = discs_[i].center;
  const Vec2 way = walkers_[i].path[states_[i].target] - here;
  const double left = Length(way);
  const double step = walkers_[i].speed * dt;
  if (left <= step) return Advance(i);
  const Vec2 direction = way * (1 / left);
  states_[i].heading = std::atan2(direction.y, direction.x);
  const int aside = std::exchange(states_[i].aside, 0);
  if (Step(i, direction, step, robot, still)) return ComesNearer(i);
  states_[i].waited += dt;
  const bool hesitates = aside == 0 && states_[i].waited < kPersonHesitates;
  if (walkers_[i].steps_aside && !hesitates && robot_stood_ >= kPersonHesitates &&
      states_[i].waited < kPersonPatience) {
    states_[i].aside = aside;
    if (StepAside(i, direction, step, robot, still)) return ComesNearer(i);
    states_[i].aside = 0;
  }
  if (states_[i].waited < kPersonPatience) return;
  states_[i].forward = !states_[i].forward;
  Advance(i);
}

void People::Step(double dt, const Disc& robot, const RayCaster& still) {
  robot_stood_ += dt;
  if (Length(robot.center - robot_) > kStandsStill) {
    robot_ = robot.center;
    robot_stood_ = 0;
  }
  for (std::size_t i = 0; i < discs_.size(); ++i) Walk(i, dt, robot, still);
}

std::vector<Stance> People::Stances() const {
  std::vector<Stance> stances(discs_.size());
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    stances[i].position = discs_[i].center;
    stances[i].heading = states_[i].heading;
    stances[i].walked = states_[i].walked;
    stances[i].walks = states_[i].waited <= 0 || states_[i].aside != 0;
    stances[i].height = walkers_[i].height;
  }
  return stances;
}

}  // namespace coppice::robot::simulation
