// How well the localization does at a site, for the bands of its monitors:
//   build/tests/bin/measure_site campus [ROUNDS]
// Rounds through all places of its map, forth and back along each edge that is driven, with its
// passers-by, localized as on the robot. What the monitors judge, as shares of all moments.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "robot_app/common/places/station_place.h"
#include "robot_app/common/places/topological_map.h"
#include "tests/robot_app/localization/localized_robot.h"
#include "tests/robot_app/mapping/tour.h"

namespace coppice::robot::localization {
namespace {

struct Site {
  LocalizerSettings localizer;
  simulation::Floor floor;
  TopologicalMap map;
};

Site Load(const std::string& name) {
  const std::string folder = SourceFolder() + "/robot_app/config/sites/" + name;
  Diagnostics diagnostics;
  auto floor = simulation::LoadFloor(folder + "/world.yaml", diagnostics);
  auto map = TopologicalMap::Load(folder + "/places.yaml", diagnostics);
  if (!floor || !map) throw std::runtime_error(diagnostics.ToString());
  for (auto& person : floor->people) person.steps_aside = true;  // else they and it wait for ever
  LocalizerSettings localizer;
  const YAML::Node agree = YAML::LoadFile(folder + "/slam.yaml")["localization"]["agree"];
  if (agree) localizer.agree = agree.as<double>();
  return {localizer, *std::move(floor), *std::move(map)};
}

Pose2D PoseOf(const TopologicalMap& map, int place) {
  return *map.places()[static_cast<std::size_t>(place)].pose;
}

// On from a place along all edges that lead to new ones, and back.
void Walk(const TopologicalMap& map, int from, std::vector<bool>& been, std::vector<Point2D>& way) {
  been[static_cast<std::size_t>(from)] = true;
  for (const Edge& edge : map.edges()) {
    const bool is_driven = edge.kind == EdgeKind::kDrive || edge.kind == EdgeKind::kUndock;
    if (edge.from != from || !is_driven || been[static_cast<std::size_t>(edge.to)]) continue;
    const Pose2D there = PoseOf(map, edge.to), here = PoseOf(map, from);
    way.push_back({there.x, there.y});
    Walk(map, edge.to, been, way);
    if (edge.kind == EdgeKind::kDrive) way.push_back({here.x, here.y});
  }
}

class Figures {
 public:
  explicit Figures(const char* name) : name_(name) {}
  void Add(double value) { values_.push_back(value); }
  void Print() {
    std::sort(values_.begin(), values_.end());
    std::printf("%-28s", name_);
    for (const double share : {0.0, 0.001, 0.01, 0.5, 0.99, 0.999, 1.0}) {
      const auto i = static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1));
      std::printf(" %9.3f", values_.empty() ? NAN : values_[i]);
    }
    std::printf("\n");
  }

 private:
  const char* name_;
  std::vector<double> values_;
};

struct Measured {
  Figures score{"score"}, deviation{"deviation [m]"}, confirmed{"since confirmed [s]"},
      jump{"jump of map -> odom [m]"}, error{"off the truth [m]"}, seen{"beams that meet [share]"};
  double way = 0, seconds = 0;
  int moments = 0, uncertain = 0, lost = 0;
};

double ShareThatMeets(const LaserScan& scan) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) hits += scan.Hit(i) ? 1 : 0;
  return static_cast<double>(hits) / static_cast<double>(scan.ranges.size());
}

void Look(LocalizedRobot& robot, const Pose2D& before, Measured& measured) {
  const LocalizationReport report = robot.Report();
  measured.score.Add(report.score);
  measured.deviation.Add(report.deviation);
  measured.confirmed.Add(report.seconds_since_confirmed);
  measured.jump.Add(Distance(robot.localizer().odom_in_map(), before));
  measured.error.Add(robot.Error());
  measured.seen.Add(ShareThatMeets(navigation::ScanOf(robot.world())));
  ++measured.moments;
  measured.uncertain += report.phase == LocalizationPhase::kUncertain ? 1 : 0;
  measured.lost += report.phase == LocalizationPhase::kLost ? 1 : 0;
}

// False if somebody stands in its way for ever.
bool Drive(const Site& site, const std::vector<Point2D>& way, std::uint64_t seed,
           Measured& measured) {
  const Pose2D start = PoseOf(site.map, HomeOn(site.map));
  LocalizedRobot robot(site.floor, start, seed, site.localizer);
  robot.localizer().Expect({start});
  if (site.floor.has_station) robot.Drive({-0.3, 0}, 4);
  robot.Drive({}, 1);
  mapping::Tour tour(way);
  const double deadline = robot.now() + 60 + 10 * tour.Length();
  double scan = -1;
  Pose2D odom = robot.localizer().odom_in_map();
  while (const auto command = tour.Next(robot.Truth())) {
    if (robot.now() > deadline) return false;
    robot.Step(*command);
    if (robot.localizer().scan_stamp() == scan) continue;
    scan = robot.localizer().scan_stamp();
    Look(robot, odom, measured);
    odom = robot.localizer().odom_in_map();
  }
  measured.way += tour.Length();
  measured.seconds += robot.now();
  return true;
}

void Print(Measured& measured) {
  std::printf("%.0f m in %.0f s, %d scans, UNCERTAIN %d, LOST %d\n", measured.way, measured.seconds,
              measured.moments, measured.uncertain, measured.lost);
  std::printf("%-28s %9s %9s %9s %9s %9s %9s %9s\n", "", "least", "0.1 %", "1 %", "50 %", "99 %",
              "99.9 %", "most");
  for (Figures* figures : {&measured.score, &measured.deviation, &measured.confirmed,
                           &measured.jump, &measured.error, &measured.seen}) {
    figures->Print();
  }
}

int Run(const std::string& name, int rounds) {
  const Site site = Load(name);
  std::vector<bool> been(site.map.places().size());
  std::vector<Point2D> way;
  Walk(site.map, HomeOn(site.map), been, way);
  Measured measured;
  for (int round = 1; round <= rounds; ++round) {
    if (!Drive(site, way, static_cast<std::uint64_t>(round), measured)) {
      std::printf("round %d: it did not get round\n", round);
    }
  }
  Print(measured);
  return 0;
}

}  // namespace
}  // namespace coppice::robot::localization

int main(int argc, char** argv) {
  const std::string site = argc > 1 ? argv[1] : "campus";
  try {
    return coppice::robot::localization::Run(site, argc > 2 ? std::atoi(argv[2]) : 3);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "measure_site: %s\n", error.what());
    return 2;
  }
}
