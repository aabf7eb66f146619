#include "bt_core/cli/test/random_test.h"

#include <iostream>
#include <memory>
#include <utility>

#include "bt_core/cli/plugins.h"
#include "bt_core/cli/test/random_report.h"
#include "bt_core/model/project.h"
#include "bt_core/testing/random_runs.h"
#include "bt_core/testing/random_suite.h"
#include "bt_core/testing/scenario_player.h"

namespace coppice {
namespace {

struct Subject {
  std::shared_ptr<const Program> program;
  RandomPlay play;
};

bool IsScenarioFile(const std::string& path) {
  const std::string end = ".json";
  return path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
}

// Of scenarios that do not speak of chance, the scripts of all leaves.
std::optional<ScenarioSuite> SuiteOfScenarios(const std::string& path, const Options& options,
                                              Diagnostics& diagnostics) {
  std::optional<ScenarioSuite> suite = LoadScenarios(path, diagnostics);
  if (!suite) return suite;
  if (!suite->random) suite->random = RandomPlay{{}, {}, suite->leaves, Duration(0)};
  suite->tree_id = options.Get("--tree", suite->tree_id);
  return suite;
}

std::optional<ScenarioSuite> SuiteOfTree(const std::string& path, const Options& options,
                                         Diagnostics& diagnostics) {
  const std::optional<Project> project = Project::FromFile(path, diagnostics);
  if (!project) return std::nullopt;
  const std::string main(project->main_tree());
  const std::string tree_id = options.Get("--tree", main);
  return RandomSuiteBeside(path, tree_id, tree_id == main, diagnostics);
}

Subject Load(const std::string& path, const Options& options, Diagnostics& diagnostics) {
  std::optional<ScenarioSuite> loaded = IsScenarioFile(path)
                                            ? SuiteOfScenarios(path, options, diagnostics)
                                            : SuiteOfTree(path, options, diagnostics);
  if (!loaded) return {};
  ScenarioSuite& suite = *loaded;
  suite.models_file = options.Get("--models", suite.models_file);
  std::shared_ptr<Registry> known = RegistryWithPlugins(options);
  std::optional<Project> project = Project::FromFile(suite.tree_file, diagnostics);
  if (!project || !known) return {};
  auto program = CompileSuite(suite, *std::move(project), std::move(known), diagnostics);
  if (!program || !CheckPlay(*program, *suite.random, diagnostics)) return {};
  return {std::move(program), *std::move(suite.random)};
}

// "key=value"; prints what is wrong.
bool ReadKeys(const Options& options, const Program& program, std::vector<KeyValue>& keys) {
  for (const std::string& text : options.GetAll("--set")) {
    const std::size_t sign = text.find('=');
    Outcome checked = Problem{"expected KEY=VALUE"};
    if (sign != std::string::npos) {
      const std::string value = text.substr(sign + 1);
      keys.push_back({{}, text.substr(0, sign), value, KindOfText(value)});
      checked = CheckKeyValue(program, keys.back());
    }
    if (checked) continue;
    std::cerr << "--set " << text << ": " << checked.problem() << "\n";
    return false;
  }
  return true;
}

}  // namespace

int RunRandomTest(const Options& options) {
  RandomRunOptions how;
  const std::int64_t runs = options.Whole("--random", 0);
  how.seed = static_cast<std::uint64_t>(options.Whole("--seed", 1));
  how.most_ticks = static_cast<std::uint64_t>(options.Whole("--ticks", 10000));
  int status = 0;
  for (const std::string& path : options.files) {
    Diagnostics diagnostics;
    Subject subject = Load(path, options, diagnostics);
    RandomRunOptions here = how;
    if (!subject.program) std::cerr << diagnostics.ToString();
    if (!subject.program || !ReadKeys(options, *subject.program, here.set)) return 2;
    here.play = std::move(subject.play);
    RandomRuns random(std::move(subject.program), std::move(here));
    for (std::int64_t i = 0; i < runs; ++i) random.Run();
    const Coverage& coverage = random.coverage();
    std::cout << (options.Has("--json") ? CoverageJson(coverage)
                                        : path + ": " + CoverageText(coverage));
    if (!coverage.findings.empty()) status = 1;
  }
  return status;
}

}  // namespace coppice
