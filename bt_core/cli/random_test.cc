#include "bt_core/cli/random_test.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

#include "bt_core/cli/plugins.h"
#include "bt_core/cli/random_report.h"
#include "bt_core/model/project.h"
#include "bt_core/testing/random_runs.h"
#include "bt_core/testing/scenario_player.h"

namespace coppice {
namespace {

constexpr std::int64_t kMostRuns = 1'000'000'000;

struct Subject {
  std::shared_ptr<const Program> program;
  RandomPlay play;
};

bool IsScenarioFile(const std::string& path) {
  const std::string end = ".json";
  return path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
}

bool IsAbout(const ScenarioSuite& suite, const std::string& tree_file) {
  std::error_code ignored;
  return std::filesystem::equivalent(suite.tree_file, tree_file, ignored);
}

// Of a tree: how the file of its scenarios, which lies beside it, plays it by chance.
std::optional<ScenarioSuite> SuiteOf(const std::string& path, Diagnostics& diagnostics) {
  if (IsScenarioFile(path)) {
    std::optional<ScenarioSuite> suite = LoadScenarios(path, diagnostics);
    if (suite && !suite->random) suite->random = RandomPlay{{}, suite->leaves, Duration(0)};
    return suite;
  }
  const std::string beside = std::filesystem::path(path).replace_extension(".test.json").string();
  if (std::filesystem::exists(beside)) {
    std::optional<ScenarioSuite> suite = LoadScenarios(beside, diagnostics);
    if (!suite || (suite->random && IsAbout(*suite, path))) return suite;
  }
  ScenarioSuite suite;
  suite.tree_file = path;
  suite.random.emplace();
  return suite;
}

// False, with the reason, if the tree has not these keys.
bool CheckChoices(const Program& program, const RandomPlay& play, Diagnostics& diagnostics) {
  for (const std::vector<KeyValue>& choice : play.set) {
    for (const KeyValue& value : choice) {
      const std::string problem = CheckKeyValue(program, value);
      if (!problem.empty()) diagnostics.Error(value.where, problem);
    }
  }
  return !diagnostics.has_errors();
}

Subject Load(const std::string& path, const Options& options, Diagnostics& diagnostics) {
  std::optional<ScenarioSuite> loaded = SuiteOf(path, diagnostics);
  if (!loaded) return {};
  ScenarioSuite& suite = *loaded;
  suite.tree_id = options.Get("--tree", suite.tree_id);
  suite.models_file = options.Get("--models", suite.models_file);
  std::shared_ptr<Registry> known = RegistryWithPlugins(options);
  std::optional<Project> project = Project::FromFile(suite.tree_file, diagnostics);
  if (!project || !known) return {};
  auto program = CompileSuite(suite, *std::move(project), std::move(known), diagnostics);
  if (!program || !CheckChoices(*program, *suite.random, diagnostics)) return {};
  return {std::move(program), *std::move(suite.random)};
}

// "key=value"; prints what is wrong.
bool ReadKeys(const Options& options, const Program& program, std::vector<KeyValue>& keys) {
  for (const std::string& text : options.GetAll("--set")) {
    const std::size_t sign = text.find('=');
    std::string problem = "expected KEY=VALUE";
    if (sign != std::string::npos) {
      const std::string value = text.substr(sign + 1);
      keys.push_back({{}, text.substr(0, sign), value, KindOfText(value)});
      problem = CheckKeyValue(program, keys.back());
    }
    if (problem.empty()) continue;
    std::cerr << "--set " << text << ": " << problem << "\n";
    return false;
  }
  return true;
}

// A number of this option from 1 to `most`; nothing, with a message, if it is none.
std::optional<std::uint64_t> CountOf(const Options& options, const std::string& name,
                                     std::int64_t otherwise, std::int64_t most) {
  if (!options.Has(name)) return otherwise;
  const std::optional<std::int64_t> number = options.GetNumber(name);
  if (number && *number >= 1 && *number <= most) return *number;
  std::cerr << name << ": expected a number from 1 to " << most << "\n";
  return std::nullopt;
}

}  // namespace

int RunRandomTest(const Options& options) {
  RandomRunOptions how;
  const auto runs = CountOf(options, "--random", 0, kMostRuns);
  const auto seed = CountOf(options, "--seed", 1, INT64_MAX / 2);
  const auto ticks = CountOf(options, "--ticks", 10000, kMostRuns);
  if (!runs || !seed || !ticks) return 2;
  how.seed = *seed;
  how.most_ticks = *ticks;
  int status = 0;
  for (const std::string& path : options.files) {
    Diagnostics diagnostics;
    Subject subject = Load(path, options, diagnostics);
    RandomRunOptions here = how;
    if (!subject.program) std::cerr << diagnostics.ToString();
    if (!subject.program || !ReadKeys(options, *subject.program, here.set)) return 2;
    here.leaves = std::move(subject.play.leaves);
    here.choices = std::move(subject.play.set);
    here.lasts = subject.play.lasts;
    RandomRuns random(std::move(subject.program), std::move(here));
    for (std::uint64_t i = 0; i < *runs; ++i) random.Run();
    const Coverage& coverage = random.coverage();
    std::cout << (options.Has("--json") ? CoverageJson(coverage)
                                        : path + ": " + CoverageText(coverage));
    if (!coverage.findings.empty()) status = 1;
  }
  return status;
}

}  // namespace coppice
