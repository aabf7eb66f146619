// The scenarios (docs/testing.md) that lie beside the open files: what there is, and how they went
// the last time. They are played on the texts in memory.
//
//   ScenarioTests tests;
//   tests.Look({"trees/patrol.xml"});
//   tests.Run(project, "*");
//   tests.all()[0].state;
#ifndef COPPICE_EDITOR_SIMULATION_SCENARIO_TESTS_H_
#define COPPICE_EDITOR_SIMULATION_SCENARIO_TESTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/testing/scenario.h"
#include "editor/files/open_project.h"

namespace coppice::editor {

struct ScenarioTest {
  /// kBroken: the file or its tree cannot be read; `name` is empty then.
  enum class State : std::uint8_t { kNotRun, kPassed, kFailed, kBroken };

  std::string file;
  std::string tree_file;
  std::string name;
  SourceLocation where;
  State state = State::kNotRun;
  std::vector<coppice::Difference> differences;  ///< of kFailed
  std::string problem;                           ///< of kBroken, with its place
  std::uint64_t ticks = 0;
};

class ScenarioTests {
 public:
  /// Reads every *.test.json in the folders of these files. What is known of tests that have not
  /// changed stays.
  void Look(const std::vector<std::string>& open_files);

  /// Plays those whose name fits; `*` stands for any characters. With a file only its own.
  void Run(OpenProject& files, const std::string& pattern, const std::string& file = {});

  const std::vector<ScenarioTest>& all() const { return tests_; }
  std::size_t Count(ScenarioTest::State state) const;

 private:
  void Read(const std::string& path);

  std::vector<ScenarioTest> tests_;
};

/// Adds a scenario to the file of its tree (ScenarioFileOf in bt_core/testing/random_suite.h),
/// which is made if there is none; what else stands in it stays as it is. If the tree needs models
/// of node types, the file names one of `known_models` that has them, or one with the text `models`
/// that is written beside it. Returns the path, or empty with the reason in `diagnostics`.
std::string SaveScenario(const Scenario& scenario, const std::string& tree_file,
                         const std::string& tree_id, const std::vector<std::string>& known_models,
                         const std::string& models, Diagnostics& diagnostics);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_SCENARIO_TESTS_H_
