#include "bt_core/analysis/play/scenario_models.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <system_error>

#include "bt_core/model/write_file.h"
#include "bt_core/testing/scenario.h"
#include "bt_core/testing/stand_in.h"

namespace coppice {
namespace {

bool Describes(const Project& models, const std::vector<std::string>& types) {
  return std::all_of(types.begin(), types.end(),
                     [&](const std::string& type) { return models.models().count(type) > 0; });
}

// "patrol.models.xml" of "patrol.test.json".
std::string FileBeside(const std::string& scenario_file) {
  std::filesystem::path path = scenario_file;
  path.replace_extension();
  if (path.extension() == ".test") path.replace_extension();
  return path.string() + ".models.xml";
}

// What the scenarios of a file name already.
std::string NamedModels(const std::string& scenario_file) {
  std::error_code error;
  if (!std::filesystem::exists(scenario_file, error)) return {};
  Diagnostics ignored;  // whoever adds to the file says what is wrong with it
  const std::optional<ScenarioSuite> suite = LoadScenarios(scenario_file, ignored);
  return suite ? suite->models_file : std::string();
}

}  // namespace

std::vector<std::string> DecoratorsWithoutModel(const Project& project) {
  std::vector<std::string> types;
  const auto registry = ScenarioRegistry(project);
  for (const std::string& id : registry->Ids()) {
    const Registry::Entry& entry = *registry->Find(id);
    if (NeedsScript(entry) && !IsStandIn(entry)) types.push_back(id);
  }
  return types;
}

std::string ModelsOfRecord(const TreeDescription& tree) {
  const Registry built_in;
  std::set<std::string, std::less<>> used;
  for (const DescribedNode& node : tree.nodes) {
    if (!built_in.Find(node.id)) used.insert(node.id);
  }
  Diagnostics ignored;  // of a record without models
  const std::optional<Document> document = Document::FromText(tree.models, "models", ignored);
  std::string text = "<root BTCPP_format=\"4\">\n  <TreeNodesModel>\n";
  if (document) {
    for (const Element& element : document->elements()) {
      const Attribute* id = document->FindAttribute(element, "ID");
      if (!id || element.tag == "SubTree" || used.count(id->value) == 0) continue;
      text += "    " + tree.models.substr(element.offset, element.end - element.offset) + "\n";
    }
  }
  return text + "  </TreeNodesModel>\n</root>\n";
}

std::string ModelsForScenario(const std::string& scenario_file, const std::string& tree_file,
                              const std::vector<std::string>& known, const std::string& models,
                              Diagnostics& diagnostics) {
  Diagnostics ignored;  // the tree was compiled for the scenario; not all known files must fit
  const std::optional<Project> project = Project::FromFile(tree_file, ignored);
  if (!project) return {};
  const std::vector<std::string> needed = DecoratorsWithoutModel(*project);
  if (needed.empty()) return {};
  const std::string named = NamedModels(scenario_file);
  if (!named.empty()) return named;
  for (const std::string& file : known) {
    const std::optional<Project> described = Project::FromFile(file, ignored);
    if (described && Describes(*described, needed)) return file;
  }
  const std::string file = FileBeside(scenario_file);
  const std::optional<Project> recorded = Project::FromText(models, file, ignored);
  if (!recorded || !Describes(*recorded, needed)) {
    diagnostics.Warning({scenario_file, 0, 0},
                        "there is no model of the decorator " + needed.front() +
                            ": name a file that has it as the \"models\" of the scenarios");
    return {};
  }
  return WriteFile(file, models, diagnostics) ? file : std::string();
}

}  // namespace coppice
