#include "robot_app/training/moving_crowd.h"

#include <algorithm>
#include <cmath>

#include "robot_app/training/draw.h"

namespace coppice::robot::training {
namespace {

using simulation::kPi;
using simulation::Stance;
using simulation::Vec2;

constexpr double kApart = 0.55;      // of two people's axes at least [m]
constexpr double kRoom = 0.28;       // around an axis [m]
constexpr double kNear = 0.2;        // the target is reached [m]
constexpr double kPatience = 1.5;    // then another way is chosen [s]
constexpr double kAcceleration = 3;  // of legs [m/s^2]
constexpr int kTries = 300;

}  // namespace

MovingCrowd::MovingCrowd(const Site& site, int count, Vec2 robot, double keep_off,
                         std::uint64_t seed)
    : site_(site), robot_(robot), keep_off_(keep_off), random_(seed) {
  for (int i = 0; i < count; ++i) {
    people_.push_back({});
    intents_.push_back({});
    Choose(people_.size() - 1);
    people_.back().position = intents_.back().target;
    people_.back().height = Draw(random_, 1.5, 1.95);
    people_.back().clothes = Draw(random_, 0.1, 0.8);
    intents_.back().waits = 0;
  }
}

bool MovingCrowd::CanStand(Vec2 at, std::size_t who) const {
  if (!IsFree(site_, at, kRoom) || simulation::Length(at - robot_) < keep_off_) return false;
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (i != who && simulation::Length(people_[i].position - at) < kApart) return false;
  }
  return true;
}

void MovingCrowd::Choose(std::size_t who) {
  Intent& intent = intents_[who];
  const Vec2 half = site_.area.size * 0.5;
  intent.speed = Draw(random_, 0.6, 1.4);
  intent.patience = 0;
  intent.waits = random_() % 3 == 0 ? Draw(random_, 1, 5) : 0;
  for (int i = 0; i < kTries; ++i) {
    const bool meets = people_.size() > 1 && random_() % 4 == 0;
    const Vec2 at = meets ? people_[random_() % people_.size()].position +
                                simulation::Direction(Draw(random_, -kPi, kPi)) * 0.75
                          : site_.area.center + Vec2{Draw(random_, -half.x, half.x),
                                                     Draw(random_, -half.y, half.y)};
    intent.target = at;
    if (CanStand(at, who)) return;
  }
}

// Steps with a velocity that is as near to `wanted` as legs can change it; false if there is
// somebody or something.
bool MovingCrowd::Push(std::size_t who, Vec2 wanted, double dt) {
  Stance& person = people_[who];
  Vec2& velocity = intents_[who].velocity;
  const Vec2 change = wanted - velocity;
  const double most = kAcceleration * dt;
  const Vec2 next = simulation::Length(change) <= most
                        ? wanted
                        : velocity + change * (most / simulation::Length(change));
  const Vec2 there = person.position + next * dt;
  if (!CanStand(there, who)) return false;
  velocity = next;
  person.position = there;
  person.heading = std::atan2(next.y, next.x);
  person.walked += simulation::Length(next) * dt;
  person.walks = true;
  return true;
}

void MovingCrowd::Walk(std::size_t who, double dt) {
  Stance& person = people_[who];
  Intent& intent = intents_[who];
  const Vec2 way = intent.target - person.position;
  person.walks = false;
  if (simulation::Length(way) < kNear) {
    intent.velocity = {0, 0};
    intent.waits -= dt;
    if (intent.waits <= 0) Choose(who);
    return;
  }
  const double straight = std::atan2(way.y, way.x);
  for (const double turn : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    if (Push(who, simulation::Direction(straight + turn) * intent.speed, dt)) {
      intent.patience = 0;
      return;
    }
  }
  intent.velocity = {0, 0};  // nobody runs into anybody
  intent.patience += dt;
  if (intent.patience > kPatience) Choose(who);
}

void MovingCrowd::Step(double dt) {
  for (std::size_t i = 0; i < people_.size(); ++i) Walk(i, dt);
}

}  // namespace coppice::robot::training
