#include "tests/robot_app/slam/carried_study.h"

#include <cmath>
#include <cstdio>

#include "robot_app/slam/graph/floor_pose.h"
#include "tests/support/folders.h"

namespace coppice::robot::slam {
namespace {

using localization::LocalizationPhase;
using localization::LocalizedRobot;
using simulation::Pose2;
using simulation::Vec2;

constexpr std::uint64_t kMapSeed = 2000003;  // nothing was learnt from it
constexpr std::uint64_t kLookSeed = 2000033;
constexpr int kPeople = 4;
constexpr double kTurning = 0.4;    // rad/s
constexpr double kLookEvery = 0.7;  // rad of a turn
constexpr double kLatency = 0.3;    // s, from a picture to its hint
constexpr double kNotices = 10;     // s
constexpr double kStands = 5;       // s
constexpr double kRight = 0.5;      // m
constexpr double kMoment = 1;       // between looks: people stand elsewhere

Pose2 ToPose2(const Pose2D& pose) { return {pose.x, pose.y, pose.yaw}; }

std::string Data(const char* name) { return SourceFolder() + "/robot_app/slam/data/" + name; }

training::TourSettings Settings(std::uint64_t seed, double light) {
  training::TourSettings settings;
  settings.seed = seed;
  settings.light = light;
  settings.people = kPeople;
  return settings;
}

// One place, and what the robot makes of it.
class Visit {
 public:
  Visit(KnownInstitute& institute, const Pose2D& begin, std::uint64_t seed,
        const CarriedOptions& options)
      : institute_(institute),
        options_(options),
        moment_(static_cast<double>(seed) * 100),
        robot_(institute.floor(), begin, seed) {}

  LocalizedRobot& robot() { return robot_; }
  CarriedOutcome& outcome() { return outcome_; }

  // Sees where it stands by pictures; what they say comes a little later.
  void Look(double turning) {
    if (!options_.with_pictures || robot_.IsOk()) return;
    const double stamp = robot_.now();
    const auto hint = institute_.Look(robot_.Truth(), moment_ += kMoment);
    if (hint) {
      ++outcome_.hints;
      if (Distance(*hint, robot_.Truth()) > kRight) ++outcome_.wrong_hints;
    }
    Drive(turning, kLatency);
    if (hint) robot_.localizer().AddHint(stamp, *hint);
  }

  void Drive(double turning, double seconds) {
    robot_.DriveUntil({0, turning}, seconds, [this, last = robot_.now()]() mutable {
      const double now = robot_.now();
      if (robot_.IsOk() && robot_.Error() > kRight) outcome_.wrong += now - last;
      last = now;
      return false;
    });
  }

  void TurnOnce() {
    for (double turned = 0; turned < 2 * M_PI; turned += kLookEvery) {
      const double begin = robot_.now();
      Look(kTurning);
      Drive(kTurning, kLookEvery / kTurning - (robot_.now() - begin));
    }
    Drive(0, 2);
  }

 private:
  KnownInstitute& institute_;
  const CarriedOptions options_;
  double moment_;
  LocalizedRobot robot_;
  CarriedOutcome outcome_;
};

}  // namespace

std::vector<Vec2> RoundOfAllRooms() {
  std::vector<Vec2> way = {{-0.8, 0}};
  const auto enter = [&way](double x, double side) {  // an office by its door at x
    for (const Vec2& point : std::initializer_list<Vec2>{{0, 0},
                                                         {0, 3.0},
                                                         {1.8, 4.6},
                                                         {1.8, 2.6},
                                                         {-1.6, 2.4},
                                                         {-1.4, 4.8},
                                                         {0, 3.4},
                                                         {0, 0}}) {
      way.push_back({x + point.x, side * point.y});
    }
  };
  for (const double x : {8.0, 16.0, 24.0, 32.0}) enter(x, 1);
  for (const Vec2& point : std::initializer_list<Vec2>{{42, 0.4},
                                                       {46, 0},
                                                       {47.5, 4},
                                                       {42.5, 4},
                                                       {42, 0.4},
                                                       {42.5, -3.6},
                                                       {47.5, -4.4},
                                                       {47, -1},
                                                       {42, -0.4}}) {
    way.push_back(point);
  }
  for (const double x : {32.0, 24.0, 16.0, 8.0}) enter(x, -1);
  way.push_back({-0.8, 0});
  return way;
}

KnownInstitute::KnownInstitute(const std::vector<Vec2>& way)
    : floor_(navigation::InstituteFloor()),
      sensors_(*training::SensorsOf(
          *RobotDescription::Load(SourceFolder() + "/robot_app/description/sobi.urdf"))),
      vocabulary_(*Vocabulary::Load(Data("vocabulary.txt"))),
      classifier_(*PlaceClassifier::Load(Data("places_in_clouds.yaml"))),
      mapper_(vocabulary_, classifier_) {
  const training::TourSettings settings = Settings(kMapSeed, 1);
  training::TourEyes eyes(floor_, sensors_, settings);
  mapper_.BeginSession("round");
  for (const training::Stop& stop : training::Drive(way, settings)) {
    Sight sight;
    sight.stamp = stop.way;
    sight.odometry = ToPose3({stop.odometry.x, stop.odometry.y, stop.odometry.yaw});
    if (!mapper_.IsDue(sight.odometry)) continue;
    sight.place = Pose2D{stop.truth.x, stop.truth.y, stop.truth.yaw};
    sight.cloud = eyes.TakeCloud(stop);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto seen = eyes.TakePicture(stop, i);
      sight.pictures.push_back(SeePicture(seen.colour, seen.depth, sensors_.cameras[i]));
    }
    mapper_.Add(sight);
  }
  mapper_.BeginSession("carried");
  SetLight(1);
}

void KnownInstitute::SetLight(double light) {
  eyes_ = std::make_unique<training::TourEyes>(floor_, sensors_, Settings(kLookSeed, light));
}

std::optional<Pose2D> KnownInstitute::Look(const Pose2D& truth, double moment) {
  const training::Stop stop{ToPose2(truth), {}, moment};
  std::vector<SightPicture> pictures;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto seen = eyes_->TakePicture(stop, i);
    pictures.push_back(SeePicture(seen.colour, seen.depth, sensors_.cameras[i]));
  }
  const auto known = mapper_.Recognize(pictures);
  if (!known) return std::nullopt;
  const auto frames = OnNavigationMap(mapper_.graph(), mapper_.key_frames());
  return ToPose2D(*frames[0] * mapper_.graph().poses()[known->key_frame] * known->relative);
}

CarriedOutcome PutAt(KnownInstitute& institute, const Pose2D& before, const Pose2D& place,
                     std::uint64_t seed, const CarriedOptions& options) {
  Visit visit(institute, options.carried ? before : place, seed, options);
  LocalizedRobot& robot = visit.robot();
  CarriedOutcome& outcome = visit.outcome();
  if (options.carried) {
    robot.localizer().Expect({before});
    robot.Drive({}, 1);
    robot.Carry(place);
    outcome.lost = robot.DriveUntil({}, kNotices, [&] { return robot.IsLost(); }) >= 0;
    visit.Look(0);
  } else {
    visit.Drive(0, 1);
    for (int i = 0; i < kStands; ++i) {
      visit.Look(0);
      visit.Drive(0, 1 - kLatency);
    }
  }
  visit.Drive(0, 1);
  outcome.found_standing = robot.IsOk() && robot.Error() < kRight;
  visit.TurnOnce();
  outcome.place = place;
  outcome.phase = robot.Report().phase;
  outcome.error = robot.Error();
  return outcome;
}

std::vector<CarriedOutcome> PutAnywhere(KnownInstitute& institute, int places, unsigned seed,
                                        const CarriedOptions& options,
                                        const std::function<void(double)>& say) {
  const OccupancyGrid map = navigation::MapOf(institute.floor());
  const std::vector<Pose2D> before = localization::RandomPoses(map, places, seed);
  const std::vector<Pose2D> after = localization::RandomPoses(map, places, seed + 1);
  std::vector<CarriedOutcome> outcomes;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (localization::IsSamePlace(before[i], after[i])) continue;
    outcomes.push_back(PutAt(institute, before[i], after[i], 10 * i + 1, options));
    say(static_cast<double>(i + 1) / places);
  }
  return outcomes;
}

std::string TableHead() {
  return "| | places | found standing | found | UNCERTAIN | LOST | a wrong place called OK | "
         "recognized in pictures | of them wrong |\n|---|---|---|---|---|---|---|---|---|\n";
}

std::string TableLine(const std::string& name, const std::vector<CarriedOutcome>& outcomes) {
  int standing = 0, found = 0, uncertain = 0, lost = 0, wrong = 0, hints = 0, wrong_hints = 0;
  for (const CarriedOutcome& one : outcomes) {
    standing += one.found_standing ? 1 : 0;
    found += one.found() ? 1 : 0;
    uncertain += one.phase == LocalizationPhase::kUncertain ? 1 : 0;
    lost += one.phase == LocalizationPhase::kLost ? 1 : 0;
    wrong += one.wrong > 0 || (one.phase == LocalizationPhase::kOk && !one.found()) ? 1 : 0;
    hints += one.hints;
    wrong_hints += one.wrong_hints;
  }
  char line[240];
  std::snprintf(line, sizeof(line), "| %s | %zu | %d | %d | %d | %d | %d | %d | %d |\n",
                name.c_str(), outcomes.size(), standing, found, uncertain, lost, wrong, hints,
                wrong_hints);
  return line;
}

}  // namespace coppice::robot::slam
