// What the file of a tree's scenarios says of running it by chance: its "random" (docs/testing.md).
//
//   auto suite = RandomSuiteBeside("patrol.xml", "Patrol", true, diagnostics);  // patrol.test.json
//   options.play = *suite->random;
#ifndef COPPICE_BT_CORE_TESTING_RANDOM_SUITE_H_
#define COPPICE_BT_CORE_TESTING_RANDOM_SUITE_H_

#include <optional>
#include <string>

#include "bt_core/testing/scenario.h"

namespace coppice {

/// Where the scenarios of a tree are kept: those of the main tree (without ID) of "a/patrol.xml" in
/// "a/patrol.test.json", those of "Dock" in "a/patrol.Dock.test.json".
std::string ScenarioFileOf(const std::string& tree_file, const std::string& tree_id);

/// The scenarios about this tree (without ID: about any of the file) that lie beside its file and
/// speak of chance: those in its own file, else in that of the main tree. If there are none, a
/// suite of the tree alone, without a file; it has an empty `random`. Nothing, with the reasons, if
/// a file has errors.
std::optional<ScenarioSuite> RandomSuiteBeside(const std::string& tree_file,
                                               const std::string& tree_id, bool is_main,
                                               Diagnostics& diagnostics);

/// False, with the places, if the tree has not the keys that the play sets, or they cannot have
/// these values.
bool CheckPlay(const Program& program, const RandomPlay& play, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_RANDOM_SUITE_H_
