// Makes scenarios of what was played, and writes them as people do.
//
//   Scenario scenario = RecordScenario(*program, leaves, steps, "recharges when low");
//   std::string text = PrintScenarios(suite);                       // a new file
//   auto changed = AddScenario(text, "patrol.test.json", scenario, diagnostics);   // one more
//
// ParseScenarios(PrintScenarios(suite)) is the suite again, but for the places.
#ifndef COPPICE_BT_CORE_TESTING_SCENARIO_WRITER_H_
#define COPPICE_BT_CORE_TESTING_SCENARIO_WRITER_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/testing/scenario.h"

namespace coppice {

/// Plays the steps and expects of each what happened: the status of the tree, what the leaves did,
/// and the values that keys got. Steps in which nothing new happens become one, if the scenario
/// passes then too. `leaves` are the scenario's own rules, `seed` that of what they do by chance.
Scenario RecordScenario(const Program& program, const std::vector<PlacedRule>& leaves,
                        const std::vector<ScenarioStep>& steps, std::string name,
                        std::uint64_t seed = 0);

/// The pattern by which scenarios call a node: its name, if no other has it, else its path.
std::string PatternOf(const Program& program, NodeIndex node);

/// The text of a file; the tree is written relative to it.
std::string PrintScenarios(const ScenarioSuite& suite);

/// The text of a file with one scenario more, behind the others; nothing else of it changes. What
/// was played without the rules of that file does not get them (own_leaves). Null if the text is no
/// file of scenarios or has one of that name.
std::optional<std::string> AddScenario(const std::string& text, const std::string& file,
                                       const Scenario& scenario, Diagnostics& diagnostics);

/// Adds a scenario to a file, which is made if there is none. `models_file` is named in it,
/// relative to it, unless it names one already; empty: none is needed. False, with the reason, if
/// that cannot be: the file is broken, has one of that name, or is about another tree.
bool WriteScenario(const Scenario& scenario, const std::string& file, const std::string& tree_file,
                   const std::string& tree_id, Diagnostics& diagnostics,
                   const std::string& models_file = {});

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_SCENARIO_WRITER_H_
