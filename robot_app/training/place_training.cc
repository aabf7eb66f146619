#include "robot_app/training/place_training.h"

#include <cmath>
#include <random>
#include <vector>

#include "robot_app/simulation/lidar_3d.h"
#include "robot_app/training/draw.h"
#include "robot_app/training/random_hall.h"

namespace coppice::robot::training {
namespace {

using simulation::Pose2;
using simulation::Vec2;

constexpr double kRobot = 0.4;  // m
constexpr double kSame = 1.2;   // m: pairs that are nearer are one place,
constexpr double kOther = 3;    // and those that are farther are not
constexpr int kPlaces = 4;      // in a hall, each with two turns
constexpr int kPeople = 5;
constexpr float kLidar = 1.2F;  // m above the floor

struct Turn {
  Vec2 at;
  slam::CloudDescriptor descriptor;
};

std::optional<Vec2> SomewhereNear(const Site& site, Vec2 center, Vec2 half,
                                  std::mt19937_64& random) {
  for (int i = 0; i < 50; ++i) {
    const Vec2 point = center + Vec2{Draw(random, -half.x, half.x), Draw(random, -half.y, half.y)};
    if (IsFree(site, point, kRobot)) return point;
  }
  return std::nullopt;
}

void PlacePeople(const Site& site, Vec2 robot, simulation::Scene& scene, std::mt19937_64& random) {
  std::vector<simulation::Stance> people;
  for (int i = 0; i < kPeople; ++i) {
    simulation::Stance stance;
    const auto place = SomewhereNear(site, robot, {5, 5}, random);
    if (!place || simulation::Length(*place - robot) < 0.8) continue;
    stance.position = *place;
    stance.heading = Draw(random, 0, 2 * simulation::kPi);
    people.push_back(stance);
  }
  scene.SetFigures(simulation::MakeFigures(people));
}

Turn Measure(const Site& site, Vec2 at, simulation::Scene& scene, std::mt19937_64& random) {
  PlacePeople(site, at, scene, random);
  simulation::Lidar3d lidar({}, random());
  lidar.Turn(0, 1.0001 * lidar.options().period, {at.x, at.y, Draw(random, 0, 2 * simulation::kPi)},
             scene);
  slam::CloudPoints points;
  for (const simulation::CloudPoint& point : lidar.cloud().points) {
    if (std::isfinite(point.x)) points.emplace_back(point.x, point.y, point.z + kLidar);
  }
  return {at, slam::Describe(points)};
}

std::vector<Turn> TurnsIn(const Site& site, std::mt19937_64& random) {
  simulation::Scene scene(site.still);
  std::vector<Turn> turns;
  for (int i = 0; i < kPlaces; ++i) {
    const auto place = SomewhereNear(site, {0, 0}, site.area.size * 0.5, random);
    if (!place) continue;
    turns.push_back(Measure(site, *place, scene, random));
    const auto beside = SomewhereNear(site, *place, {0.6, 0.6}, random);
    if (beside) turns.push_back(Measure(site, *beside, scene, random));
  }
  return turns;
}

}  // namespace

Expected<slam::PlaceClassifier> TrainPlaces(const PlaceTrainingOptions& options,
                                            const std::function<void(double)>& say) {
  std::mt19937_64 random(options.seed);
  std::vector<slam::PlaceClassifier::Example> examples;
  std::vector<Turn> others;  // of the hall before
  for (int i = 0; i < options.halls; ++i) {
    std::vector<Turn> turns = TurnsIn(MakeRandomHall(random), random);
    for (std::size_t a = 0; a < turns.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const double way = simulation::Length(turns[a].at - turns[b].at);
        if (way > kSame && way < kOther) continue;
        examples.push_back({slam::Compare(turns[a].descriptor, turns[b].descriptor), way <= kSame});
      }
      if (a < others.size()) {
        examples.push_back({slam::Compare(turns[a].descriptor, others[a].descriptor), false});
      }
    }
    others = std::move(turns);
    say(static_cast<double>(i) / options.halls);
  }
  return slam::PlaceClassifier::Train(examples);
}

}  // namespace coppice::robot::training
