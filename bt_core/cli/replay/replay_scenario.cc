#include "bt_core/cli/replay/replay_scenario.h"

#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "bt_core/analysis/play/scenario_models.h"
#include "bt_core/analysis/play/scenario_of.h"
#include "bt_core/model/project.h"
#include "bt_core/testing/scenario_writer.h"

namespace coppice {
namespace {

// The end of the part that --from or --to names.
std::size_t PlaceOf(const Options& options, const std::string& name, const Recording& run,
                    std::size_t otherwise) {
  if (!options.Has(name)) return otherwise;
  return run.FindTime(RecordTime(options, name, run.start()));
}

// Empty if the file has this main tree anyway.
std::string NeededTreeId(const std::string& tree_file, const std::string& main_tree,
                         Diagnostics& diagnostics) {
  const std::optional<Project> project = Project::FromFile(tree_file, diagnostics);
  return project && project->main_tree() == main_tree ? "" : main_tree;
}

}  // namespace

Time RecordTime(const Options& options, const std::string& name, Time start) {
  return start + Duration(static_cast<std::int64_t>(options.Real(name, 0) * 1e9));
}

int MakeScenario(const Options& options, const Recording& run) {
  const std::size_t first = PlaceOf(options, "--from", run, 0);
  const std::size_t last = PlaceOf(options, "--to", run, run.ticks().size());
  Diagnostics diagnostics;
  const auto recorded =
      ScenarioOf(run, first, last + 1, options.Get("--name", "as recorded"), diagnostics);
  if (!recorded) {
    std::cerr << diagnostics.ToString();
    return 1;
  }
  const std::string tree_file = options.Get("--tree-file", recorded->tree_file);
  std::error_code error;
  if (!std::filesystem::exists(tree_file, error)) {
    std::cerr << tree_file << ": there is no such file; --tree-file says where the tree lies\n";
    return 2;
  }
  const std::string tree_id = NeededTreeId(tree_file, recorded->tree_id, diagnostics);
  const std::string file = options.Get("--scenario");
  std::vector<std::string> known;
  if (options.Has("--models")) known.push_back(options.Get("--models"));
  const std::string models =
      ModelsForScenario(file, tree_file, known, recorded->models, diagnostics);
  const bool written =
      WriteScenario(recorded->scenario, file, tree_file, tree_id, diagnostics, models);
  std::cerr << diagnostics.ToString();
  if (!written) return 1;
  std::cout << file << ": \"" << recorded->scenario.name << "\", "
            << recorded->scenario.steps.size() << " steps from tick "
            << run.ticks()[recorded->first_tick].number << "\n";
  return 0;
}

}  // namespace coppice
