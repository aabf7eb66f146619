#include "bt_core/analysis/recorded_tree.h"

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "bt_core/engine/compile/compiler.h"
#include "bt_core/engine/compile/model_registry.h"

namespace coppice {
namespace {

// The trees and models of all documents in one, so that no include has to be found again.
std::string JoinDocuments(const TreeDescription& tree, Diagnostics& diagnostics) {
  std::string xml = "<root BTCPP_format=\"4\">\n";
  for (const DescribedDocument& described : tree.documents) {
    const std::optional<Document> document =
        Document::FromText(described.text, described.file, diagnostics);
    if (!document) continue;
    const Element& root = document->element(kRootElement);
    for (ElementIndex i = root.first_child; i != kNoElement;
         i = document->element(i).next_sibling) {
      const Element& element = document->element(i);
      if (element.tag == "include") continue;
      xml.append(document->text(), element.offset, element.end - element.offset);
      xml += '\n';
    }
  }
  return xml + "</root>\n";
}

void AddRecordedModels(const TreeDescription& tree, Registry& registry) {
  if (tree.models.empty()) return;
  Diagnostics ignored;  // models are written by the engine
  const std::optional<Project> models = Project::FromText(tree.models, "models", ignored);
  if (models) AddModels(*models, registry);
}

void CompileDocuments(RecordedTree& recorded, std::shared_ptr<Registry> registry,
                      Diagnostics& diagnostics) {
  const TreeDescription& tree = *recorded.description;
  Diagnostics problems;
  std::optional<Project> project =
      Project::FromText(JoinDocuments(tree, problems), "record", problems);
  if (project && project->Find(tree.main_tree)) {
    Problems found(problems);
    Tolerance tolerance;
    tolerance.types_without_class = true;  // nothing of the user is run
    recorded.project = std::make_shared<const Project>(*std::move(project));
    auto program = TreeCompiler(recorded.project, std::move(registry), tolerance, found)
                       .Run(tree.main_tree, *recorded.project->Find(tree.main_tree));
    if (!problems.has_errors()) {
      recorded.program = std::move(program);
      return;
    }
  }
  for (const Diagnostic& problem : problems.all()) {
    diagnostics.Warning(problem.where, "the recorded tree cannot be compiled: " + problem.message,
                        problem.hint);
  }
}

// What differs between a described node and that of the program; empty if nothing does.
std::string Difference(const TreeDescription& tree, const Program& program) {
  if (program.nodes.size() != tree.nodes.size()) {
    return "has " + std::to_string(program.nodes.size()) + " nodes instead of " +
           std::to_string(tree.nodes.size());
  }
  for (NodeIndex i{0}; i < tree.nodes.size(); ++i) {
    const DescribedNode& node = tree.nodes[i];
    if (program.Path(i) == node.path && program.info[i].parent == node.parent) continue;
    return "has " + program.Path(i) + " in the place of " + node.path;
  }
  return {};
}

// Slots by name: keys by scope and key, ports by the path of their node.
class SlotMatcher {
 public:
  SlotMatcher(const TreeDescription& tree, const Program& program)
      : tree_(tree), program_(program) {
    for (SlotIndex i{0}; i < tree.slots.size(); ++i) {
      const DescribedSlot& slot = tree.slots[i];
      by_name_.emplace(Name(slot.has_key ? slot.scope : std::string_view(), slot.name), i);
    }
  }

  std::vector<SlotIndex> Match() {
    recorded_.assign(program_.layout.slots.size(), kNoSlot);
    for (SlotIndex i{0}; i < recorded_.size(); ++i) {
      const SlotDefinition& slot = program_.layout.slots[i];
      if (!slot.key.empty()) recorded_[i] = Find(program_.layout.scopes[slot.scope], slot.key);
    }
    for (NodeIndex i{0}; i < program_.nodes.size(); ++i) MatchPorts(i);
    return std::move(recorded_);
  }

 private:
  using Name = std::pair<std::string_view, std::string_view>;

  SlotIndex Find(std::string_view scope, std::string_view name) const {
    const auto found = by_name_.find(Name(scope, name));
    return found == by_name_.end() ? kNoSlot : found->second;
  }

  void MatchPorts(NodeIndex node) {
    const Registry::Entry* entry = program_.info[node].entry;
    if (!entry) return;
    const std::uint32_t first = program_.FirstPort(node);
    for (std::size_t k = 0; k < entry->declarations.size(); ++k) {
      const PortDeclaration& port = entry->declarations[k];
      const SlotIndex slot = program_.ports[first + k].slot;
      if (slot == kNoSlot) continue;
      if (recorded_[slot] == kNoSlot) recorded_[slot] = OfPort(node, port.name);
    }
  }

  SlotIndex OfPort(NodeIndex node, const std::string& port) const {
    for (const DescribedPort& described : tree_.nodes[node].ports) {
      if (described.name == port) return described.slot;
    }
    return Find({}, tree_.nodes[node].path + "." + port);
  }

  const TreeDescription& tree_;
  const Program& program_;
  std::map<Name, SlotIndex> by_name_;
  std::vector<SlotIndex> recorded_;
};

void MatchSlots(RecordedTree& tree) {
  tree.recorded_slots = SlotMatcher(*tree.description, *tree.program).Match();
  for (SlotIndex i{0}; i < tree.recorded_slots.size(); ++i) {
    if (tree.recorded_slots[i] < tree.program_slots.size()) {
      tree.program_slots[tree.recorded_slots[i]] = i;
    }
  }
}

bool EndsIn(const std::string& path, const std::string& end) {
  if (path.size() <= end.size()) return path == end;
  const std::size_t at = path.size() - end.size();
  return path[at - 1] == '/' && path.compare(at, end.size(), end) == 0;
}

}  // namespace

std::string RecordedTree::NameOf(NodeIndex node) const {
  const std::string& path = PathOf(node);
  return path.substr(path.rfind('/') + 1);
}

NodeIndex RecordedTree::Find(const std::string& path, Diagnostics& diagnostics) const {
  std::vector<NodeIndex> found;
  std::vector<std::string> paths;
  for (NodeIndex i{0}; i < description->nodes.size(); ++i) {
    paths.push_back(PathOf(i));
    if (paths.back() == path) return i;
    if (EndsIn(paths.back(), path)) found.push_back(i);
  }
  if (found.size() == 1) return found.front();
  std::string hint = found.empty() ? DidYouMean(path, paths) : "it may be";
  for (std::size_t i = 0; i < found.size() && i < 5; ++i) hint += " " + PathOf(found[i]);
  diagnostics.Error({}, (found.empty() ? "no node \"" : "more than one node \"") + path + "\"",
                    hint);
  return kNoNode;
}

RecordedTree CompileRecorded(const TreeDescription& description, std::shared_ptr<Registry> registry,
                             Diagnostics& diagnostics) {
  RecordedTree tree;
  tree.description = std::make_shared<const TreeDescription>(description);
  tree.shape = ShapeOf(description);
  tree.program_slots.assign(description.slots.size(), kNoSlot);
  AddRecordedModels(description, *registry);
  registry->SetFallback([](const std::string&) { return nullptr; });
  CompileDocuments(tree, std::move(registry), diagnostics);
  if (!tree.program) return tree;
  const std::string difference = Difference(description, *tree.program);
  if (difference.empty()) {
    MatchSlots(tree);
  } else {
    diagnostics.Warning({}, "the recorded tree, compiled again, " + difference);
    tree.program = nullptr;
  }
  return tree;
}

}  // namespace coppice
