#include "robot_app/training/vocabulary_training.h"

#include <random>
#include <vector>

#include "robot_app/simulation/camera/rgbd_camera.h"
#include "robot_app/training/draw.h"
#include "robot_app/training/random_hall.h"

namespace coppice::robot::training {
namespace {

using simulation::Pose2;
using simulation::Vec2;

constexpr double kRobot = 0.4;  // m: what the camera's robot needs for itself
constexpr int kTries = 100;

Pose2 SomewhereIn(const Site& site, std::mt19937_64& random) {
  Pose2 pose;
  for (int i = 0; i < kTries; ++i) {
    const Vec2 half = site.area.size * 0.5;
    const Vec2 point{Draw(random, -half.x, half.x), Draw(random, -half.y, half.y)};
    pose = {point.x, point.y, Draw(random, 0, 2 * simulation::kPi)};
    if (IsFree(site, point, kRobot)) break;
  }
  return pose;
}

}  // namespace

Expected<slam::Vocabulary> TrainVocabulary(const VocabularyTrainingOptions& options,
                                           const std::function<void(double)>& say) {
  std::mt19937_64 random(options.seed);
  const simulation::RgbdOptions camera;
  std::vector<std::vector<slam::Descriptor>> pictures;
  for (int i = 0; i < options.pictures; ++i) {
    Site site = MakeRandomHall(random);
    site.still.light = Draw(random, 0.05, 1);
    const Pose2 lens = SomewhereIn(site, random);
    const double height = Draw(random, 0.9, 1.5);
    const auto seen = simulation::RgbdCamera(camera, random())
                          .Take(simulation::Scene(site.still), {}, lens, height);
    const slam::CameraMount mount = slam::LevelCamera(camera.lens, 0, 0, 0, height);
    pictures.push_back(slam::FindFeatures(seen.colour, seen.depth, mount).descriptors);
    say(static_cast<double>(i) / options.pictures);
  }
  return slam::Vocabulary::Train(pictures, {10, 3, options.seed});
}

}  // namespace coppice::robot::training
