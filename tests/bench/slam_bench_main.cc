// How well places are recognized and how good maps of many sessions become: `./dev bench slam`.
//
//   places in pictures        recognized of all stops, by how bright it is; none may be wrong
//   places in clouds          the same in the dark, of all places and of those nearby
//   maps of several sessions  closures, error of the ways, cells of the grid, time of an update
//   updates                   time of one in a map of 5 000 key frames (--updates 5000)
//   pose graphs               of up to 5 000 key frames: what an update has to solve, and its time
//
// With --pictures FOLDER it paints the curve and the map of the last seed.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/model/write_file.h"
#include "robot_app/common/compressed_picture.h"
#include "robot_app/slam/drawing/map_picture.h"
#include "robot_app/slam/map/map_voxels.h"
#include "robot_app/slam/map/slam_map_file.h"
#include "robot_app/training/maps/building_tour.h"
#include "robot_app/training/maps/update_figures.h"
#include "robot_app/training/place_figures.h"
#include "robot_app/training/slam_figures.h"
#include "tests/support/folders.h"

namespace coppice::robot::training {
namespace {

const Command kBench{
    "coppice_slam_bench",
    "how well places are recognized, and how good maps become",
    {"", 0, 0},
    "All of it takes some ten minutes for each seed on one core.",
    {CommandOption::Whole("--seeds", "N", 0, 1000, "maps of four sessions each; else 3"),
     CommandOption::Whole("--first", "SEED", 1, 1000, "of these seeds; else 1"),
     CommandOption::Flag("--maps-only", "measure neither places nor pose graphs"),
     CommandOption::Flag("--graphs-only", "measure pose graphs alone, in half a minute"),
     CommandOption::Whole("--updates", "N", 100, 1000000,
                          "measure updates alone, of a map that grows to N key frames"),
     CommandOption::Whole("--rounds", "N", 1, 1000,
                          "measure clouds alone, of what is near, on N rounds in the dark"),
     CommandOption::Text("--pictures", "FOLDER", "paint the curve and the last map"),
     CommandOption::Text("--save", "FOLDER", "keep the last map, for coppice-map")}};

constexpr std::uint64_t kSeed = 1000001;  // nothing was learnt from it

// After a long way the mapper's doubt is:
constexpr double kDoubt = 6;        // m
constexpr double kTurnDoubt = 0.4;  // rad
constexpr double kDark = 0.02;      // of full light

int Fail(const std::string& problem) {
  std::fprintf(stderr, "coppice_slam_bench: %s\n", problem.c_str());
  return 1;
}

void Say(double share) { std::fprintf(stderr, "\r%3.0f %% ", 100 * share); }

std::string Data(const char* name) { return SourceFolder() + "/robot_app/slam/data/" + name; }

struct Known {
  simulation::Floor floor;
  RobotSensors sensors;
  slam::Vocabulary vocabulary;
  slam::PlaceClassifier classifier;
};

Expected<Known> LoadKnown() {
  Diagnostics diagnostics;
  auto floor = simulation::LoadFloor(
      SourceFolder() + "/robot_app/config/sites/institute/world.yaml", diagnostics);
  if (!floor) return Problem{diagnostics.ToString()};
  const auto robot = RobotDescription::Load(SourceFolder() + "/robot_app/description/sobi.urdf");
  if (!robot) return Problem{robot.problem()};
  auto sensors = SensorsOf(*robot);
  if (!sensors) return Problem{sensors.problem()};
  auto vocabulary = slam::Vocabulary::Load(Data("vocabulary.txt"));
  if (!vocabulary) return Problem{vocabulary.problem()};
  auto classifier = slam::PlaceClassifier::Load(Data("places_in_clouds.yaml"));
  if (!classifier) return Problem{classifier.problem()};
  return Known{*std::move(floor), *std::move(sensors), *std::move(vocabulary),
               *std::move(classifier)};
}

int Paint(const Options& options, const char* name, const Picture& picture) {
  const auto bytes = EncodeJpeg(picture, 90);
  Diagnostics diagnostics;
  const std::string file = (std::filesystem::path(options.Get("--pictures")) / name).string();
  if (WriteFile(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, diagnostics))
    return 0;
  return Fail(diagnostics.ToString());
}

int MeasurePlaces(const Known& known, const Options& options) {
  PlaceStudy study{
      known.floor, known.sensors, RoundOfTheInstitute(), {1, 0.3, 0.1, 0.05, 0.02}, kSeed};
  const auto pictures = MeasurePictures(known.vocabulary, study, Say);
  std::printf("\nplaces in pictures\n%s", Table(pictures).c_str());
  slam::Curve curve{"pictures", {}, {}}, clouds{"clouds, of what is near", {}, {}};
  for (const PlaceFigures& one : pictures) {
    curve.x.push_back(one.light);
    curve.y.push_back(one.recall());
  }
  study.lights = {kDark};
  for (const double doubt : {1e9, kDoubt}) {
    study.doubt = doubt;
    study.turn_doubt = doubt > 100 ? M_PI : kTurnDoubt;
    const auto figures = MeasureClouds(known.classifier, study, Say);
    std::printf("\nplaces in clouds, of those within %g m\n%s", doubt, Table(figures).c_str());
    clouds.x = {curve.x.front(), curve.x.back()};
    clouds.y = {figures[0].recall(), figures[0].recall()};
  }
  std::fflush(stdout);
  if (!options.Has("--pictures")) return 0;
  return Paint(options, "places_by_light.jpg",
               slam::DrawCurves({curve, clouds}, "light", "places recognized, none wrong", true));
}

// Each round with other people, doors and noise.
void MeasureRounds(const Known& known, int rounds) {
  PlaceStudy study{known.floor, known.sensors, RoundOfTheInstitute(), {}, kSeed};
  study.lights.assign(static_cast<std::size_t>(rounds), kDark);
  study.doubt = kDoubt;
  study.turn_doubt = kTurnDoubt;
  const auto figures = MeasureClouds(known.classifier, study, Say);
  int asked = 0, answered = 0, wrong = 0;
  for (const PlaceFigures& one : figures) {
    asked += one.asked;
    answered += one.answered;
    wrong += one.wrong;
  }
  std::printf("\nplaces in clouds, of those within %g m, on %d rounds\n%s", kDoubt, rounds,
              Table(figures).c_str());
  std::printf("of all %d stops %.1f %% recognized, %d wrongly\n", asked,
              100.0 * (answered - wrong) / asked, wrong);
  std::fflush(stdout);
}

void MeasureGraphs() {
  std::vector<GraphFigures> all;
  for (const int sessions : {1, 2, 5}) {
    BuildingTourSettings building;
    building.sessions = sessions;
    all.push_back(MeasureGraph(TourOfABuilding(building), {}));
  }
  std::printf("\npose graphs of a building that nobody built\n%s", Table(all).c_str());
  std::fflush(stdout);
}

void MeasureUpdatesOf(const Known& known, std::size_t key_frames) {
  const SlamStudy study{known.floor,
                        known.sensors,
                        known.vocabulary,
                        known.classifier,
                        RoundOfTheInstitute(),
                        {1, 0.3, 0.04},
                        kSeed,
                        {}};
  const auto figures = MeasureUpdates(study, key_frames, key_frames / 10, Say);
  std::printf("\nupdates of a map with rounds through the institute\n%s", Table(figures).c_str());
  std::fflush(stdout);
}

int MeasureMaps(const Known& known, const Options& options) {
  std::vector<SlamFigures> all;
  const auto seeds = static_cast<std::uint64_t>(options.Whole("--seeds", 3));
  const auto first = static_cast<std::uint64_t>(options.Whole("--first", 1));
  slam::SlamMap last;
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
    const SlamStudy study{
        known.floor,           known.sensors,       known.vocabulary, known.classifier,
        RoundOfTheInstitute(), {1, 0.3, 0.1, 0.04}, kSeed + seed,     {}};
    SlamResult result = MeasureSlam(study, Say);
    all.push_back(result.figures);
    std::printf("\nmap of seed %llu\n%s", static_cast<unsigned long long>(seed),
                Table({result.figures}).c_str());
    std::fflush(stdout);
    last = std::move(result.map);
  }
  if (all.size() > 1) std::printf("\nall maps\n%s", Table(all).c_str());
  if (all.empty()) return 0;
  if (options.Has("--save")) {
    const auto saved = slam::SaveSlamMap(options.Get("--save"), last);
    if (!saved) return Fail(saved.problem());
  }
  if (!options.Has("--pictures")) return 0;
  const slam::MapperSettings mapper;
  const auto voxels = slam::VoxelsOf(last, 0, mapper.lidar, mapper.resolution);
  return Paint(options, "slam_map.jpg", slam::DrawPlan(voxels.Project(), last, 0));
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kBench, arguments);
  if (options.exit) return *options.exit;
  if (options.Has("--graphs-only")) return MeasureGraphs(), 0;
  const auto known = LoadKnown();
  if (!known) return Fail(known.problem());
  if (options.Has("--updates")) {
    MeasureUpdatesOf(*known, static_cast<std::size_t>(options.Whole("--updates", 5000)));
    return 0;
  }
  if (options.Has("--rounds")) {
    MeasureRounds(*known, static_cast<int>(options.Whole("--rounds", 20)));
    return 0;
  }
  if (!options.Has("--maps-only")) {
    MeasureGraphs();
    if (const int status = MeasurePlaces(*known, options)) return status;
  }
  return MeasureMaps(*known, options);
}

}  // namespace
}  // namespace coppice::robot::training

int main(int argc, char** argv) { return coppice::robot::training::Main({argv + 1, argv + argc}); }
