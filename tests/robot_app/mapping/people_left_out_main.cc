// Whether localization and mapping would gain by leaving people out of their scans:
//   build/tests/bin/people_left_out
// One round through the institute, localized and mapped, with everything that the scanner sees and
// without the beams that end at people, as a robot sees it that knows exactly where everybody is.
#include <algorithm>
#include <cstdio>
#include <string>

#include "tests/robot_app/localization/localized_robot.h"
#include "tests/robot_app/mapping/map_quality.h"
#include "tests/robot_app/mapping/mapped_robot.h"

namespace coppice::robot::mapping {
namespace {

constexpr Pose2D kStart{-0.5, 0, 0};
constexpr int kSeeds = 3;

// As many as that, the shipped four among them, up and down corridor and hall.
simulation::Floor FloorWith(std::size_t people) {
  simulation::Floor floor = navigation::InstituteFloor();
  while (floor.people.size() < people) {
    const auto i = static_cast<double>(floor.people.size());
    auto person = floor.people.front();
    person.name = "walker" + std::to_string(floor.people.size());
    person.speed = 0.7 + 0.05 * i;
    person.path = {{2 + 2.5 * i, 0.9 - 0.18 * i}, {47 - 1.5 * i, 0.9 - 0.18 * i}};
    floor.people.push_back(person);
  }
  for (auto& person : floor.people) person.steps_aside = true;  // else they and it wait for ever
  return floor;
}

struct Result {
  double mean = 0, worst = 0;    // of the localization [m]
  int steps = 0, uncertain = 0;  // of them
  double off = 0;                // of the mapped way, the worst [m]
  double right = 0;              // share of the map's cells within 0.1 m of the floor's
};

void Localize(const simulation::Floor& floor, std::uint64_t seed, const navigation::Look& look,
              Result& result) {
  localization::LocalizedRobot robot(floor, kStart, seed);
  robot.SetLook(look);
  robot.localizer().Expect({kStart});
  robot.Drive({}, 1);
  Tour tour(RoundOfTheInstitute());
  const double deadline = robot.now() + 60 + 10 * tour.Length();
  while (const auto command = tour.Next(robot.Truth())) {
    if (robot.now() > deadline) {
      std::printf("somebody stands in its way for ever\n");
      return;
    }
    robot.Step(*command);
    ++result.steps;
    if (!robot.IsOk()) ++result.uncertain;
    result.mean += robot.Error();
    result.worst = std::max(result.worst, robot.Error());
  }
}

void Map(const simulation::Floor& floor, std::uint64_t seed, const navigation::Look& look,
         Result& result) {
  MappedRobot robot(floor, kStart, seed);
  robot.SetLook(look);
  if (!robot.Drive(RoundOfTheInstitute())) std::printf("it did not get round\n");
  result.off = std::max(result.off, robot.farthest_off());
  result.right += ShareNear(robot.mapper().Map(), navigation::MapOf(floor), 0.1) / kSeeds;
}

void Print(std::size_t people, const char* what, const navigation::Look& look) {
  const simulation::Floor floor = FloorWith(people);
  Result result;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Localize(floor, seed, look, result);
    Map(floor, seed, look, result);
  }
  std::printf("%6zu  %-12s %8.4f %8.3f %10d %10.3f %12.4f\n", people, what,
              result.mean / result.steps, result.worst, result.uncertain, result.off, result.right);
  std::fflush(stdout);
}

}  // namespace
}  // namespace coppice::robot::mapping

int main() {
  using namespace coppice::robot;  // NOLINT: the whole program
  std::printf("people  scans        mean [m] worst [m]  uncertain  mapped [m]    map right\n");
  for (const std::size_t people : {4U, 10U, 16U}) {
    mapping::Print(people, "all", navigation::SeesAll);
    mapping::Print(people, "without them", navigation::ScanWithoutPeople);
  }
}
