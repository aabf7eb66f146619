// A small floor: a corridor of three places, a room behind a door at its middle, a second way round
// from west to east through a yard, a station at its west end, and a room upstairs.
//
//      room
//        | (door)
//   west - middle - east - (elsewhere) attic
//   | \_____ yard _____/
//   station
#ifndef COPPICE_TESTS_ROBOT_APP_COMMON_PLACES_SAMPLE_MAP_H_
#define COPPICE_TESTS_ROBOT_APP_COMMON_PLACES_SAMPLE_MAP_H_

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "robot_app/common/places/topological_map.h"
#include "tests/support/folders.h"

namespace coppice::robot {

inline TopologicalMap SampleMap() {
  const std::string path = testing::TempDir() + "sample_places.yaml";
  std::ofstream(path) << R"(
places:
  - {name: west, x: 0, y: 0, categories: [lounge]}
  - {name: middle, x: 10, y: 0}
  - {name: east, x: 20, y: 0, yaw: 1, categories: [lounge]}
  - {name: yard, x: 10, y: -20}
  - {name: room, x: 10, y: 4, yaw: 1.5, categories: [office]}
  - {name: station, x: -2, y: 0, yaw: 3, categories: [station]}
  - {name: attic, categories: [office]}
  - {name: island, x: 90, y: 90}
edges:
  - {from: west, to: middle, both_ways: true}
  - {from: middle, to: east, both_ways: true}
  - {from: west, to: yard, both_ways: true}
  - {from: yard, to: east, both_ways: true}
  - {from: middle, to: room, by: door, both_ways: true}
  - {from: west, to: station, by: dock}
  - {from: station, to: west, by: undock}
  - {from: east, to: attic, by: elsewhere, 
     words: {en: Take the ladder., de: Nehmen Sie die Leiter.}}
)";
  Diagnostics diagnostics;
  auto map = TopologicalMap::Load(path, diagnostics);
  EXPECT_TRUE(map) << diagnostics.ToString();
  return map.value_or(TopologicalMap());
}

inline TopologicalMap ShippedMap() {
  Diagnostics diagnostics;
  auto map = TopologicalMap::Load(SourceFolder() + "/robot_app/config/sites/institute/places.yaml",
                                  diagnostics);
  EXPECT_TRUE(map) << diagnostics.ToString();
  return map.value_or(TopologicalMap());
}

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_COMMON_PLACES_SAMPLE_MAP_H_
