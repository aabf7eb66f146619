#include <chrono>
#include <iostream>
#include <memory>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/plain_output.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/test/random_test.h"
#include "bt_core/cli/test/test_report.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/model/project.h"
#include "bt_core/model/write_file.h"
#include "bt_core/testing/scenario.h"

namespace coppice {
namespace {

constexpr double kMostRuns = 1e9;

TestedScenario Play(const Program& program, const ScenarioSuite& suite, const Scenario& scenario) {
  const auto start = std::chrono::steady_clock::now();
  TestedScenario tested{scenario.name, RunScenario(program, suite, scenario), 0};
  tested.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return tested;
}

TestedFile TestFile(const std::string& path, const Options& options,
                    std::shared_ptr<Registry> known) {
  TestedFile tested{path, "", {}};
  Diagnostics diagnostics;
  std::optional<ScenarioSuite> suite = LoadScenarios(path, diagnostics);
  std::shared_ptr<const Program> program;
  if (suite) {
    suite->models_file = options.Get("--models", suite->models_file);
    std::optional<Project> project = Project::FromFile(suite->tree_file, diagnostics);
    if (project) {
      program = CompileSuite(*suite, *std::move(project), std::move(known), diagnostics);
    }
  }
  if (!program) {
    tested.errors = diagnostics.ToString();
    return tested;
  }
  for (const Scenario& scenario : suite->scenarios) {
    if (!FitsWildcards(options.Get("--filter", "*"), scenario.name)) continue;
    tested.scenarios.push_back(Play(*program, *suite, scenario));
  }
  return tested;
}

int ExitStatus(const std::vector<TestedFile>& files) {
  int status = 0;
  for (const TestedFile& file : files) {
    if (!file.errors.empty()) return 2;
    if (!Passed(file)) status = 1;
  }
  return status;
}

}  // namespace

const Command& TestCommand() {
  static const Command command{
      "coppice test",
      "play scenarios with whole trees",
      {"FILE...", 1, kAnyNumber},
      R"(Plays the scenarios of each file with the tree that it names, on simulated time.
With --random, FILE is a tree, or scenarios: then their tree and their "random", or the scripts of
their leaves. Of NAME.xml the "random" of NAME.test.json is taken.
Leaves that are not built in are played by scripts; a decorator that is not built in needs a model
or a script. The format: docs/testing.md.)",
      {CommandOption::Text("--filter", "PATTERN",
                           "only scenarios whose name fits; * stands for any characters"),
       CommandOption::Text("--models", "FILE",
                           "the <TreeNodesModel> of the robot's node types, in place of the one "
                           "that the file of scenarios names"),
       CommandOption::Text("--plugin", "FILE.so",
                           "a library with node types: they run as they are unless a script plays "
                           "them; may be given several times"),
       CommandOption::Flag("--json", "the result as one JSON object"),
       CommandOption::Text("--junit", "FILE", "also writes the result for continuous integration"),
       CommandOption::Whole("--random", "RUNS", 1, kMostRuns,
                            "runs a tree so often with leaves that do something by chance; prints "
                            "how often each node was ticked and what it returned, and what went "
                            "wrong"),
       CommandOption::Whole("--seed", "S", 1, INT64_MAX / 2,
                            "of the first random run, the next has S + 1; else 1"),
       CommandOption::Whole("--ticks", "N", 1, kMostRuns,
                            "breaks off a random run that is not done after so many; else 10000"),
       CommandOption::Text("--tree", "ID", "which tree of the file, with --random"),
       CommandOption::Text("--set", "KEY=VALUE", "a key before the first tick, with --random")}};
  return command;
}

int RunTest(const Arguments& arguments) {
  const Options options = ParseOptions(TestCommand(), arguments);
  if (options.exit) return *options.exit;
  const PlainOutput output;
  if (options.Has("--random")) return RunRandomTest(options);
  std::vector<TestedFile> files;
  std::size_t played = 0;
  for (const std::string& path : options.files) {
    std::shared_ptr<Registry> known = RegistryWithPlugins(options);
    if (!known) return 2;
    files.push_back(TestFile(path, options, std::move(known)));
    played += files.back().scenarios.size();
  }
  std::cout << (options.Has("--json") ? ReportJson(files) : ReportText(files));
  if (options.Has("--junit")) {
    Diagnostics diagnostics;
    if (!WriteFile(options.Get("--junit"), ReportJUnit(files), diagnostics)) {
      std::cerr << diagnostics.ToString();
      return 2;
    }
  }
  const int status = ExitStatus(files);
  if (status == 0 && played == 0) {
    std::cerr << "no scenario fits \"" << options.Get("--filter") << "\"\n";
    return 2;
  }
  return status;
}

}  // namespace coppice
