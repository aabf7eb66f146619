#include "robot_app/docking/contact_wiggle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::robot::docking {
namespace {

// Where to, in units of the way: on, back, on again.
constexpr std::array<double, 3> kMoves = {1, -1, 0.5};
constexpr double kThere = 0.004;        // m
constexpr double kLongestMove = 4.0;    // s; the station may hold the robot before it gets there
constexpr double kFarthestStart = 0.3;  // from the docked pose [m]

}  // namespace

void ContactWiggle::Start(const DockInput& input) {
  *this = ContactWiggle(settings_);
  if (!StandsInStation(input, kFarthestStart)) {
    state_ = State::kFailed;
    message_ = "the robot does not stand on the station";
    return;
  }
  start_ = input.pose;
  entered_ = input.now;
  state_ = State::kMoving;
}

Velocity2D ContactWiggle::Update(const DockInput& input) {
  if (!active() || WatchCurrent(input)) return {};
  if (state_ == State::kMoving) return Move(input);
  if (input.now - entered_ > settings_.wiggle_wait) NextMove(input);
  return {};
}

// True while the station serves the battery: then the robot stands still.
bool ContactWiggle::WatchCurrent(const DockInput& input) {
  if (!IsServed(input, settings_)) {
    charging_since_ = -1;
    return false;
  }
  if (charging_since_ < 0) charging_since_ = input.now;
  if (input.now - charging_since_ >= settings_.charging_for) {
    state_ = State::kDone;
    message_ = "charging after move " + std::to_string(move_ + 1);
  }
  return true;
}

Velocity2D ContactWiggle::Move(const DockInput& input) {
  const double target = kMoves[static_cast<std::size_t>(move_)] * settings_.wiggle_way;
  const double left = target - RelativeTo(start_, input.pose).x;
  if (std::abs(left) < kThere || input.now - entered_ > kLongestMove) {
    state_ = State::kWaiting;
    entered_ = input.now;
    return {};
  }
  return {std::copysign(std::min(settings_.wiggle_speed, std::abs(left) + 0.01), left), 0};
}

void ContactWiggle::NextMove(const DockInput& input) {
  entered_ = input.now;
  ++move_;
  if (move_ < static_cast<int>(kMoves.size())) {
    state_ = State::kMoving;
    return;
  }
  state_ = State::kFailed;
  message_ = input.battery_known ? "no charging current, wherever the robot presses"
                                 : "the battery does not report";
}

}  // namespace coppice::robot::docking
