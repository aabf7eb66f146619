#include "robot_app/training/placed_people.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot_app/training/draw.h"

namespace coppice::robot::training {
namespace {

using simulation::kPi;
using simulation::Pose2;
using simulation::Stance;
using simulation::Vec2;

constexpr double kSensorRoom = 0.4;   // free around the robot's middle [m]
constexpr double kPersonRoom = 0.28;  // and around a person's
constexpr double kFarthest = 20;      // [m]
constexpr int kTries = 200;

Pose2 PlaceSensor(const Site& site, std::mt19937_64& random) {
  const Vec2 half = site.area.size * 0.5;
  Pose2 pose;
  for (int i = 0; i < kTries; ++i) {
    const Vec2 local{Draw(random, -half.x, half.x), Draw(random, -half.y, half.y)};
    const Vec2 point = site.area.center + simulation::Rotated(local, site.area.yaw);
    pose = {point.x, point.y, Draw(random, -kPi, kPi)};
    if (IsFree(site, point, kSensorRoom)) break;
  }
  return pose;
}

class Crowd {
 public:
  Crowd(const Site& site, Vec2 sensor, std::mt19937_64& random)
      : site_(site), sensor_(sensor), random_(random) {}

  void AddSomebody() {
    // Near ones matter most and are rarest by area.
    const double distance = 0.7 + (kFarthest - 0.7) * std::pow(Draw(random_, 0, 1), 2);
    const Vec2 at = sensor_ + simulation::Direction(Draw(random_, -kPi, kPi)) * distance;
    switch (random_() % 4) {
      case 0:
        return AddGroup(at);
      case 1:
        return AddHidden(at);
      default:
        Add(at, false);
    }
  }

  std::vector<PlacedPerson> placed;

 private:
  bool Fits(Vec2 at) const {
    return IsFree(site_, at, kPersonRoom) && simulation::Length(at - sensor_) > 0.65 &&
           std::all_of(placed.begin(), placed.end(), [&](const PlacedPerson& other) {
             return simulation::Length(other.stance.position - at) > 0.5;
           });
  }

  bool Add(Vec2 at, bool in_group) {
    if (!Fits(at)) return false;
    Stance stance;
    stance.position = at;
    stance.heading = Draw(random_, -kPi, kPi);
    stance.walks = random_() % 2 == 0;
    stance.walked = Draw(random_, 0, 10);
    stance.height = Draw(random_, 1.45, 2.0);
    stance.clothes = Draw(random_, 0.05, 0.85);
    placed.push_back({stance, in_group});
    return true;
  }

  void AddGroup(Vec2 at) {
    const double turn = Draw(random_, -kPi, kPi);
    const double apart = Draw(random_, 0.52, 0.8);
    const Vec2 others[] = {at + simulation::Direction(turn) * apart,
                           at + simulation::Direction(turn + Draw(random_, 1, kPi)) * apart};
    if (Fits(at) && Fits(others[0]) && Fits(others[1]) && Add(at, true)) {
      for (const Vec2 other : others) Add(other, true);
    }
  }

  // One before the other, a little aside.
  void AddHidden(Vec2 at) {
    const Vec2 view = at - sensor_;
    const double distance = simulation::Length(view);
    if (distance < 1.6 || !Add(at, false)) return;
    const Vec2 along = view * (1 / distance);
    const double nearer = Draw(random_, 0.55, std::min(2.5, distance - 0.7));
    const double aside = Draw(random_, -0.35, 0.35) * (distance - nearer) / distance;
    Add(at - along * nearer + Vec2{-along.y, along.x} * aside, false);
  }

  const Site& site_;
  Vec2 sensor_;
  std::mt19937_64& random_;
};

}  // namespace

PlacedPeople PlacePeople(const Site& site, std::mt19937_64& random) {
  PlacedPeople people;
  people.robot = PlaceSensor(site, random);
  Crowd crowd(site, people.robot.position(), random);
  const std::uint64_t wanted = random() % 11;
  for (int i = 0; i < kTries && crowd.placed.size() < wanted; ++i) crowd.AddSomebody();
  people.people = std::move(crowd.placed);
  return people;
}

std::vector<simulation::Figure> FiguresOf(const PlacedPeople& people) {
  std::vector<simulation::Figure> figures;
  for (const PlacedPerson& person : people.people) figures.push_back(MakeFigure(person.stance));
  return figures;
}

}  // namespace coppice::robot::training
