#include "bt_core/testing/random_suite.h"

#include <filesystem>

#include "bt_core/testing/scenario_player.h"

namespace coppice {
namespace {

namespace fs = std::filesystem;

struct TreeOfFile {
  const std::string& file;
  const std::string& id;
  bool is_main;
};

bool IsAbout(const ScenarioSuite& suite, const TreeOfFile& tree) {
  std::error_code ignored;  // of a file that there is not
  const bool same_tree =
      suite.tree_id == tree.id || tree.id.empty() || (suite.tree_id.empty() && tree.is_main);
  return same_tree && fs::equivalent(suite.tree_file, tree.file, ignored);
}

}  // namespace

std::string ScenarioFileOf(const std::string& tree_file, const std::string& tree_id) {
  return fs::path(tree_file).replace_extension("").string() +
         (tree_id.empty() ? "" : "." + tree_id) + ".test.json";
}

std::optional<ScenarioSuite> RandomSuiteBeside(const std::string& tree_file,
                                               const std::string& tree_id, bool is_main,
                                               Diagnostics& diagnostics) {
  for (const std::string& id : {tree_id, std::string()}) {
    const std::string path = ScenarioFileOf(tree_file, id);
    std::error_code ignored;  // a file that cannot be seen is none
    if (!fs::exists(path, ignored)) continue;
    std::optional<ScenarioSuite> suite = LoadScenarios(path, diagnostics);
    if (!suite) return std::nullopt;
    if (suite->random && IsAbout(*suite, {tree_file, tree_id, is_main})) return suite;
  }
  ScenarioSuite suite;
  suite.tree_file = tree_file;
  suite.tree_id = tree_id;
  suite.random.emplace();
  return suite;
}

bool CheckPlay(const Program& program, const RandomPlay& play, Diagnostics& diagnostics) {
  bool good = true;
  for (const std::vector<KeyValue>& choice : play.set) {
    for (const KeyValue& value : choice) {
      if (const Outcome checked = CheckKeyValue(program, value); !checked) {
        diagnostics.Error(value.where, checked.problem());
        good = false;
      }
    }
  }
  return good;
}

}  // namespace coppice
