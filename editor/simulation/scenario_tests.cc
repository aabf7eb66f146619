#include "editor/simulation/scenario_tests.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "bt_core/analysis/play/scenario_models.h"
#include "bt_core/testing/random_suite.h"
#include "bt_core/testing/scenario_writer.h"
#include "editor/files/linked_project.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr char kEnding[] = ".test.json";

bool EndsIn(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::set<std::string> ScenarioFilesIn(const fs::path& folder) {
  std::set<std::string> files;
  std::error_code ignored;  // a folder that cannot be read has none
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    const fs::path path = folder / entry.path().filename();
    if (EndsIn(path.string(), kEnding)) files.insert(path.string());
  }
  return files;
}

}  // namespace

void ScenarioTests::Look(const std::vector<std::string>& open_files) {
  std::set<std::string> files;
  for (const std::string& path : open_files) {
    files.merge(ScenarioFilesIn(fs::path(path).parent_path()));
  }
  const std::vector<ScenarioTest> known = std::exchange(tests_, {});
  for (const std::string& file : files) Read(file);
  for (ScenarioTest& test : tests_) {
    const auto same = std::find_if(known.begin(), known.end(), [&](const ScenarioTest& other) {
      return other.file == test.file && other.name == test.name && !other.name.empty();
    });
    if (same == known.end()) continue;
    test.state = same->state;
    test.differences = same->differences;
    test.ticks = same->ticks;
  }
}

void ScenarioTests::Read(const std::string& path) {
  Diagnostics diagnostics;
  const std::optional<ScenarioSuite> suite = LoadScenarios(path, diagnostics);
  if (!suite) {
    ScenarioTest broken;
    broken.file = path;
    broken.where = diagnostics.all().front().where;
    broken.state = ScenarioTest::State::kBroken;
    broken.problem = diagnostics.ToString();
    tests_.push_back(std::move(broken));
    return;
  }
  for (const Scenario& scenario : suite->scenarios) {
    ScenarioTest test;
    test.file = path;
    test.tree_file = suite->tree_file;
    test.name = scenario.name;
    test.where = scenario.where;
    tests_.push_back(std::move(test));
  }
}

void ScenarioTests::Run(OpenProject& files, const std::string& pattern, const std::string& file) {
  struct Loaded {
    std::optional<ScenarioSuite> suite;
    std::shared_ptr<const Program> program;
    std::string problem;
  };
  std::map<std::string, Loaded> loaded;
  const auto load = [&](const std::string& path) {
    Loaded result;
    Diagnostics diagnostics;
    result.suite = LoadScenarios(path, diagnostics);
    if (result.suite) {
      auto project = ReadOpenProject(files, result.suite->tree_file, diagnostics);
      if (project) {
        result.program = CompileSuite(*result.suite, *std::move(project), nullptr, diagnostics);
      }
    }
    result.problem = diagnostics.ToString();
    return result;
  };
  for (ScenarioTest& test : tests_) {
    if (test.name.empty() || !FitsWildcards(pattern, test.name)) continue;
    if (!file.empty() && file != test.file) continue;
    if (loaded.count(test.file) == 0) loaded.emplace(test.file, load(test.file));
    const Loaded& from = loaded.at(test.file);
    test.differences.clear();
    test.problem = from.problem;
    test.state = ScenarioTest::State::kBroken;
    if (!from.program) continue;
    for (const Scenario& scenario : from.suite->scenarios) {
      if (scenario.name != test.name) continue;
      ScenarioResult result = RunScenario(*from.program, *from.suite, scenario);
      test.state =
          result.differences.empty() ? ScenarioTest::State::kPassed : ScenarioTest::State::kFailed;
      test.differences = std::move(result.differences);
      test.ticks = result.ticks;
    }
  }
}

std::size_t ScenarioTests::Count(ScenarioTest::State state) const {
  return static_cast<std::size_t>(
      std::count_if(tests_.begin(), tests_.end(),
                    [state](const ScenarioTest& test) { return test.state == state; }));
}

std::string SaveScenario(const Scenario& scenario, const std::string& tree_file,
                         const std::string& tree_id, const std::vector<std::string>& known_models,
                         const std::string& models, Diagnostics& diagnostics) {
  std::string path = ScenarioFileOf(tree_file, tree_id);
  const std::string named = ModelsForScenario(path, tree_file, known_models, models, diagnostics);
  const bool written = WriteScenario(scenario, path, tree_file, tree_id, diagnostics, named);
  return written ? path : std::string();
}

}  // namespace coppice::editor
