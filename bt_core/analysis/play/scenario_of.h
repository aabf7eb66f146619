// A recorded run as a scenario (bt_core/testing/scenario.h): scripts play the leaves of the user
// with the results, times and outputs of the record, values from outside are written when they
// came, and what the tree did is what is expected. So a night on the robot becomes a test.
//
//   auto recorded = ScenarioOf(run, run.Find(120), run.Find(300), "stuck at the door",
//   diagnostics); WriteScenario(recorded->scenario, "patrol.test.json", "patrol.xml",
//   recorded->tree_id, ...);
#ifndef COPPICE_BT_CORE_ANALYSIS_PLAY_SCENARIO_OF_H_
#define COPPICE_BT_CORE_ANALYSIS_PLAY_SCENARIO_OF_H_

#include <cstddef>
#include <optional>
#include <string>

#include "bt_core/analysis/recording.h"
#include "bt_core/base/diagnostic.h"
#include "bt_core/testing/scenario.h"

namespace coppice {

struct RecordedScenario {
  Scenario scenario;
  std::string tree_file;       ///< of the main tree, as the robot calls it
  std::string tree_id;         ///< the main tree
  std::string models;          ///< of the robot's own node types in it: scenario_models.h
  std::size_t first_tick = 0;  ///< of ticks(): where it begins
};

/// Of the entries from `first` up to and without `end` of run.ticks(). A scenario begins with a
/// fresh tree, so it begins where the tree was begun: at `first` or before. Nothing is returned,
/// with the reason, if the record does not reach back so far, if something is missing within it, or
/// if the tree does not do again what it did: nodes of the user that are no leaves may have decided
/// something, or a random number.
std::optional<RecordedScenario> ScenarioOf(const Recording& run, std::size_t first, std::size_t end,
                                           std::string name, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PLAY_SCENARIO_OF_H_
