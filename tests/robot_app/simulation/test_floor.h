// A bare room for tests: x 0..20, y -2..2, the charging station at its west wall.
#ifndef COPPICE_TESTS_ROBOT_APP_SIMULATION_TEST_FLOOR_H_
#define COPPICE_TESTS_ROBOT_APP_SIMULATION_TEST_FLOOR_H_

#include <string>

#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/scene/scene.h"
#include "tests/support/folders.h"

namespace coppice::robot::simulation {

using Segments = std::vector<Segment>;

inline Floor MakeRoom() {
  Floor floor;
  floor.name = "room";
  floor.walls = {{{0, -2}, {20, -2}, {20, 2}, {0, 2}, {0, -2}}};
  floor.docked = {0.6, 0, kPi};
  floor.staging = {2, 0, kPi};
  return floor;
}

inline std::string InstituteFile() {
  return SourceFolder() + "/robot_app/config/sites/institute/world.yaml";
}

inline Floor LoadInstitute() {
  Diagnostics diagnostics;
  return LoadFloor(InstituteFile(), diagnostics).value();
}

inline Segments EdgesOf(const StillScene& still) {
  Segments edges;
  for (const Panel& panel : still.panels) edges.push_back(panel.edge);
  return edges;
}

}  // namespace coppice::robot::simulation

#endif  // COPPICE_TESTS_ROBOT_APP_SIMULATION_TEST_FLOOR_H_
