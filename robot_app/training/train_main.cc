// coppice-train: makes the files that the robot's classifiers know from, and says how good they
// are.
#include <cstdio>
#include <string>
#include <utility>

#include "bt_core/base/command_line.h"
#include "robot_app/common/shipped.h"
#include "robot_app/perception/detection/mask_detector.h"
#include "robot_app/training/leg_training.h"
#include "robot_app/training/mask_training.h"
#include "robot_app/training/people_training.h"
#include "robot_app/training/place_figures.h"
#include "robot_app/training/place_training.h"
#include "robot_app/training/tracking_figures.h"
#include "robot_app/training/vocabulary_training.h"

namespace coppice::robot::training {
namespace {

// Of a camera, as coppice-camera looks [s]: it looks oftener at the depth without the lidar.
constexpr CameraPeriods kWithLidar{0.5, 0.5};
constexpr CameraPeriods kWithoutLidar{0.2, 0.5};

const Command kTrain{
    "coppice-train",
    "learn to see people in clouds and scans of lasers, masks and places in pictures",
    {"people|legs|masks|vocabulary|places FILE", 2, 2},
    "Writes FILE, a classifier of people in clouds or of their legs in planar scans,\n"
    "learnt from simulated ones, one of faces and masks learnt from generated pictures,\n"
    "of random halls, the words of pictures (vocabulary) or a classifier of clouds\n"
    "(places) by which places are recognized. With --measure it says how well FILE\n"
    "finds people, legs or places on the institute's floor, or faces and masks in\n"
    "other pictures. The same options write the same file.",
    {CommandOption::Whole("--seed", "N", 1, 1000000000, "of the halls; else 1"),
     CommandOption::Whole("--scans", "N", 1, 100000,
                          "of a round, for people and legs, else 700; halls, for places, else 300"),
     CommandOption::Whole("--pictures", "N", 1, 100000,
                          "for masks, else 600, to measure 100; for words, else 400"),
     CommandOption::Whole("--rounds", "N", 1, 10, "else 3"),
     CommandOption::Flag("--measure", "reads FILE instead of writing it"),
     CommandOption::Flag("--without-picture", "measure people with clusters by distance alone"),
     CommandOption::Flag("--cameras", "measure also how people are followed with the cameras"),
     CommandOption::Flag("--without-depth", "measure masks with the colour alone")}};

int Fail(const std::string& problem) {
  std::fprintf(stderr, "coppice-train: %s\n", problem.c_str());
  return 1;
}

std::uint64_t SeedOf(const Options& options) {
  return static_cast<std::uint64_t>(options.Whole("--seed", 1));
}

// Nothing is measured on what was learnt from.
std::uint64_t MeasuringSeed(const Options& options) { return SeedOf(options) + 1000000; }

// Each percent once.
void Say(double share) {
  static int said = -1;
  const int percent = static_cast<int>(100 * share);
  if (percent == said) return;
  said = percent;
  std::fprintf(stderr, "\r%3d %%", percent);
}

struct SensesTried {
  const char* name;
  bool lidar, cameras, laser;
};
constexpr SensesTried kSensesTried[] = {{"lidar", true, false, false},
                                        {"lidar and cameras", true, true, false},
                                        {"cameras", false, true, false},
                                        {"laser", false, false, true},
                                        {"cameras and laser", false, true, true}};

// The cameras of the shipped robot with all that is built in.
Expected<CameraPair> MakeCameras(const std::string& classifier_file, perception::Detector& detector,
                                 const CameraPeriods& periods, std::uint64_t seed) {
  const auto robot = RobotDescription::Load(Shipped(COPPICE_ROBOT));
  if (!robot) return Problem{robot.problem()};
  std::vector<Mount> mounts;
  std::vector<perception::PeopleInPictures> people;
  for (const char* const name : {"camera_front", "camera_rear"}) {
    const auto mount = robot->MountOf(name);
    if (!mount) return Problem{mount.problem()};
    mounts.push_back(*mount);
    auto classifier = perception::PersonClassifier::Load(classifier_file);
    if (!classifier) return Problem{classifier.problem()};
    people.emplace_back(detector, std::move(*classifier));
  }
  return CameraPair(mounts, std::move(people), periods, seed);
}

// The sensors of the robot, each alone and with others; the cameras only if they are asked for, for
// they take long.
int MeasureFollowing(perception::PeopleFinder& lidar, const Options& options,
                     const TrackingScenario& scenario) {
  auto classifier = perception::LegClassifier::Load(Shipped(COPPICE_LEGS));
  if (!classifier) return Fail(classifier.problem());
  perception::LegFinder laser({}, std::move(*classifier));
  auto detector = perception::MakeDetector({});
  if (!detector) return Fail(detector.problem());
  const bool with_cameras = options.Has("--cameras");
  std::fputs("\nTen people for a minute\n", stdout);
  for (const SensesTried& tried : kSensesTried) {
    if (tried.cameras && !with_cameras) continue;
    auto cameras = MakeCameras(options.files[1], **detector,
                               tried.lidar ? kWithLidar : kWithoutLidar, scenario.seed);
    if (!cameras) return Fail(cameras.problem());
    Senses senses;
    if (tried.lidar) senses.lidar = &lidar;
    if (tried.cameras) senses.cameras = &*cameras;
    if (tried.laser) senses.legs = &laser;
    std::printf("%s: %s", tried.name, Summary(MeasureTracking(senses, scenario)).c_str());
    std::fflush(stdout);
  }
  return 0;
}

int MeasurePeopleIn(const Options& options) {
  Diagnostics diagnostics;
  const auto floor = simulation::LoadFloor(Shipped(COPPICE_FLOOR), diagnostics);
  if (!floor) return Fail(diagnostics.ToString());
  auto classifier = perception::PersonClassifier::Load(options.files[1]);
  if (!classifier) return Fail(classifier.problem());
  perception::FinderOptions finding;
  finding.candidates.with_depth_steps = !options.Has("--without-picture");
  perception::PeopleFinder finder(finding, std::move(*classifier));
  const auto scans = static_cast<int>(options.Whole("--scans", 700));
  const std::uint64_t seed = MeasuringSeed(options);
  std::fputs(Table(MeasurePeople(finder, SiteOf(*floor), scans, seed)).c_str(), stdout);
  TrackingScenario scenario;
  scenario.seed = seed;
  return MeasureFollowing(finder, options, scenario);
}

template <class Learnt>
int SaveTo(const Options& options, const Learnt& learnt) {
  std::fputs("\n", stderr);
  if (!learnt) return Fail(learnt.problem());
  const Outcome saved = learnt->Save(options.files[1]);
  return saved ? 0 : Fail(saved.problem());
}

LearningRounds RoundsOf(const Options& options, LearningRounds learning) {
  learning.seed = SeedOf(options);
  learning.scans = static_cast<int>(options.Whole("--scans", learning.scans));
  learning.rounds = static_cast<int>(options.Whole("--rounds", learning.rounds));
  return learning;
}

int TrainPeopleTo(const Options& options) {
  return SaveTo(options, TrainPeople(RoundsOf(options, {}), Say));
}

int MeasureLegsIn(const Options& options) {
  Diagnostics diagnostics;
  const auto floor = simulation::LoadFloor(Shipped(COPPICE_FLOOR), diagnostics);
  if (!floor) return Fail(diagnostics.ToString());
  auto classifier = perception::LegClassifier::Load(options.files[1]);
  if (!classifier) return Fail(classifier.problem());
  perception::LegFinder finder({}, std::move(*classifier));
  const auto scans = static_cast<int>(options.Whole("--scans", 700));
  for (const int four_legged : {0, LegTrainingOptions{}.most_four_legged}) {
    std::printf("%d chairs and tables on four legs at most\n", four_legged);
    const auto figures =
        MeasureLegs(finder, SiteOf(*floor), scans, four_legged, MeasuringSeed(options));
    std::fputs(Table(figures).c_str(), stdout);
  }
  return 0;
}

int TrainLegsTo(const Options& options) {
  LegTrainingOptions training;
  training.learning = RoundsOf(options, training.learning);
  return SaveTo(options, TrainLegs(training, Say));
}

int MeasureMasksIn(const Options& options) {
  auto classifier = perception::LoadMaskClassifier(options.files[1]);
  if (!classifier) return Fail(classifier.problem());
  const auto detector = perception::MakeMaskDetector(std::move(*classifier));
  const auto pictures = static_cast<int>(options.Whole("--pictures", 100));
  const MaskFigures figures =
      MeasureMasks(*detector, pictures, MeasuringSeed(options), !options.Has("--without-depth"));
  std::fputs(Table(figures).c_str(), stdout);
  return 0;
}

int TrainMasksTo(const Options& options) {
  MaskTrainingOptions training;
  training.seed = SeedOf(options);
  training.pictures = static_cast<int>(options.Whole("--pictures", training.pictures));
  training.rounds = static_cast<int>(options.Whole("--rounds", training.rounds));
  const auto classifier = TrainMasks(training, Say);
  std::fputs("\n", stderr);
  if (!classifier) return Fail(classifier.problem());
  const Outcome saved = Save(*classifier, options.files[1]);
  return saved ? 0 : Fail(saved.problem());
}

int TrainVocabularyTo(const Options& options) {
  VocabularyTrainingOptions training;
  training.seed = SeedOf(options);
  training.pictures = static_cast<int>(options.Whole("--pictures", training.pictures));
  return SaveTo(options, TrainVocabulary(training, Say));
}

int TrainPlacesTo(const Options& options) {
  PlaceTrainingOptions training;
  training.seed = SeedOf(options);
  training.halls = static_cast<int>(options.Whole("--scans", training.halls));
  return SaveTo(options, TrainPlaces(training, Say));
}

// Clouds are as good in the dark as by day; they are measured with all places asked for, and with
// those alone that odometry may confuse.
int MeasurePlacesIn(const Options& options) {
  Diagnostics diagnostics;
  const auto floor = simulation::LoadFloor(Shipped(COPPICE_FLOOR), diagnostics);
  if (!floor) return Fail(diagnostics.ToString());
  const auto robot = RobotDescription::Load(Shipped(COPPICE_ROBOT));
  if (!robot) return Fail(robot.problem());
  const auto sensors = SensorsOf(*robot);
  if (!sensors) return Fail(sensors.problem());
  PlaceStudy study{
      *floor, *sensors, RoundOfTheInstitute(), {1, 0.3, 0.1, 0.05, 0.02}, MeasuringSeed(options)};
  if (options.files[0] == "vocabulary") {
    const auto vocabulary = slam::Vocabulary::Load(options.files[1]);
    if (!vocabulary) return Fail(vocabulary.problem());
    std::fputs(Table(MeasurePictures(*vocabulary, study, Say)).c_str(), stdout);
    return 0;
  }
  const auto classifier = slam::PlaceClassifier::Load(options.files[1]);
  if (!classifier) return Fail(classifier.problem());
  study.lights = {0.02};
  for (const double doubt : {1e9, 5.0}) {
    study.doubt = doubt;
    std::fputs(Table(MeasureClouds(*classifier, study, Say)).c_str(), stdout);
  }
  return 0;
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kTrain, arguments);
  if (options.exit) return *options.exit;
  const bool measures = options.Has("--measure");
  if (options.files[0] == "people") {
    return measures ? MeasurePeopleIn(options) : TrainPeopleTo(options);
  }
  if (options.files[0] == "legs") {
    return measures ? MeasureLegsIn(options) : TrainLegsTo(options);
  }
  if (options.files[0] == "masks") {
    return measures ? MeasureMasksIn(options) : TrainMasksTo(options);
  }
  if (options.files[0] == "vocabulary") {
    return measures ? MeasurePlacesIn(options) : TrainVocabularyTo(options);
  }
  if (options.files[0] == "places") {
    return measures ? MeasurePlacesIn(options) : TrainPlacesTo(options);
  }
  return RefuseOptions(kTrain, "it can learn people, legs, masks, a vocabulary and places, not \"" +
                                   options.files[0] + "\"");
}

}  // namespace
}  // namespace coppice::robot::training

int main(int argc, char** argv) { return coppice::robot::training::Main({argv + 1, argv + argc}); }
