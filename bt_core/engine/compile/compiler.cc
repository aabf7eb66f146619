#include "bt_core/engine/compile/compiler.h"

#include <utility>

namespace coppice {
namespace {

// SubTrees within SubTrees multiply: a few lines of XML can ask for more than any computer has.
constexpr std::size_t kMostNodes = 1'000'000;
constexpr std::size_t kDeepest = 10'000;
constexpr std::size_t kMostPathBytes = std::size_t{32} << 20;
constexpr std::size_t kUsualPath = 100;  // bytes: of so many there may be one for each node
constexpr std::size_t kMostOtherBytes = std::size_t{128} << 20;

std::shared_ptr<Program> EmptyProgram(const Project& project,
                                      std::shared_ptr<const Registry> registry,
                                      std::vector<SourceText> texts) {
  auto program = std::make_shared<Program>();
  program->texts = std::move(texts);
  if (program->texts.empty()) {
    program->texts.reserve(project.documents().size());
    for (const Document& document : project.documents()) program->texts.emplace_back(document);
  }
  program->subtree_models = project.subtree_models();
  program->main_tree = project.main_tree();
  program->registry = std::move(registry);
  return program;
}

}  // namespace

TreeCompiler::TreeCompiler(std::shared_ptr<const Project> project,
                           std::shared_ptr<const Registry> registry, Tolerance tolerance,
                           Problems& problems, std::vector<SourceText> texts)
    : project_(std::move(project)),
      program_(EmptyProgram(*project_, std::move(registry), std::move(texts))),
      problems_(problems),
      keys_(program_->layout),
      types_(program_->layout, problems),
      scripts_(keys_, types_, problems),
      ports_(keys_, types_, scripts_, problems),
      guards_(scripts_, problems),
      lookup_(*project_, *program_->registry, tolerance, problems),
      subtrees_(*project_, *program_, keys_, types_, tolerance, problems) {}

std::shared_ptr<Program> TreeCompiler::Run(const std::string& tree_id, const TreeDefinition& tree,
                                           OuterKeys outer) {
  if (outer == OuterKeys::kApart) keys_.KeepOuterKeys();
  subtrees_.OpenMain(tree_id, tree);
  // More than one root is an error of the project; what is wrong in them is said nevertheless.
  const Document& document = project_->documents()[tree.document];
  for (ElementIndex root = document.element(tree.element).first_child; root != kNoElement;
       root = document.element(root).next_sibling) {
    Walk(Site(*project_, tree.document, root, kMainScope));
  }
  types_.Settle();
  scripts_.Compile(program_->registry->script_constants(), program_->scripts);
  GiveBackSpareMemory();
  return std::move(program_);
}

void TreeCompiler::Walk(const Site& root) {
  AddElement(root, kRootNode);
  while (!levels_.empty()) {
    if (levels_.back().next == kNoElement) {
      EndLevel();
    } else {
      AddChild();
    }
  }
}

void TreeCompiler::AddChild() {
  Level& level = levels_.back();
  const Site site(*project_, level.document, level.next, level.scope);
  level.next = site.element.next_sibling;
  AddElement(site, level.node);  // may add a level
}

void TreeCompiler::EndLevel() {
  const Level& level = levels_.back();
  program_->nodes[level.node].end = static_cast<NodeIndex>(program_->nodes.size());
  if (level.is_subtree) subtrees_.Close();
  levels_.pop_back();
}

void TreeCompiler::AddElement(const Site& site, NodeIndex parent) {
  if (IsTooBig(site)) return;
  const std::optional<FoundNode> found = lookup_.Find(site);
  if (!found) return;
  if (found->is_subtree) {
    AddSubTree(site, *found, parent);
  } else {
    AddNode(site, *found, parent);
  }
}

void TreeCompiler::AddNode(const Site& site, const FoundNode& found, NodeIndex parent) {
  const Registry::Entry* entry = found.entry;
  const NodeType type = entry ? entry->type : NodeType::kLeaf;
  const NodeIndex node = AddRecord(type, site, entry, parent);
  if (entry) ports_.Bind(*entry, site, program_->ports);
  if (type == NodeType::kLeaf || type == NodeType::kUser) AddLeaf(node);
  const ElementIndex child = site.element.first_child;
  if (child != kNoElement) {
    levels_.push_back({node, site.document_number, child, site.scope, false});
  }
}

void TreeCompiler::AddSubTree(const Site& site, const FoundNode& found, NodeIndex parent) {
  const TreeDefinition* tree = subtrees_.Find(site, found.id);
  if (!tree) return CheckGuardsOfNoNode(site);
  const NodeIndex node = AddRecord(NodeType::kSubTree, site, found.entry, parent);
  const ScopeIndex inner = subtrees_.Open(site, found.id, *tree, node);
  const Document& document = project_->documents()[tree->document];
  const ElementIndex root = document.element(tree->element).first_child;
  levels_.push_back({node, tree->document, root, inner, true});
}

// There is no node; its attributes can be wrong nevertheless.
void TreeCompiler::CheckGuardsOfNoNode(const Site& site) {
  std::vector<GuardRecord> unused;
  guards_.Read(site, kRootNode, unused);
}

NodeIndex TreeCompiler::AddRecord(NodeType type, const Site& site, const Registry::Entry* entry,
                                  NodeIndex parent) {
  const auto node = static_cast<NodeIndex>(program_->nodes.size());
  const auto first_port = static_cast<std::uint32_t>(program_->ports.size());
  const bool guarded = guards_.Read(site, node, program_->guards);
  program_->nodes.push_back({type, guarded ? NodeType::kGuarded : type, node + 1, first_port});
  program_->info.push_back({entry, parent, site.scope, site.index, site.element.offset});
  CountPath(site);
  return node;
}

// A record, and the live view, tell the path of each node and of what its ports are bound to.
void TreeCompiler::CountPath(const Site& site) {
  const std::string_view name = site.document.AttributeValue(site.element, "name");
  const std::string_view id = site.document.AttributeValue(site.element, "ID");
  const std::string_view own = !name.empty() ? name : !id.empty() ? id : site.element.tag;
  const std::size_t length = program_->layout.scopes[site.scope].size() + own.size();
  if (length > kUsualPath) long_path_bytes_ += length * (1 + site.element.attribute_count);
}

void TreeCompiler::AddLeaf(NodeIndex node) {
  NodeRecord& record = program_->nodes[node];
  const LeafRecord leaf{node, record.first_port};
  record.first_port = static_cast<std::uint32_t>(program_->leaves.size());
  program_->leaves.push_back(leaf);
}

// True from the first node on that is too much; says so once.
bool TreeCompiler::IsTooBig(const Site& site) {
  std::string reason;
  if (program_->nodes.size() >= kMostNodes) {
    reason = "the tree has more than " + std::to_string(kMostNodes) + " nodes";
  } else if (levels_.size() >= kDeepest) {
    reason = "nodes are nested more than " + std::to_string(kDeepest) + " deep";
  } else if (subtrees_.path_bytes() > kMostPathBytes) {
    reason =
        "the paths of the SubTrees take more than " + std::to_string(kMostPathBytes >> 20) + " MiB";
  } else if (long_path_bytes_ > kMostPathBytes) {
    reason = "the long paths of the nodes and their ports take more than " +
             std::to_string(kMostPathBytes >> 20) + " MiB";
  } else if (keys_.bytes() + scripts_.bytes() > kMostOtherBytes) {
    reason = "the keys, values and scripts take more than " +
             std::to_string(kMostOtherBytes >> 20) + " MiB";
  } else {
    return false;
  }
  if (!too_big_) {
    problems_.Error(site.document, site.element.offset, std::move(reason),
                    "counted with all SubTrees");
  }
  too_big_ = true;
  return true;
}

void TreeCompiler::GiveBackSpareMemory() {
  program_->nodes.shrink_to_fit();
  program_->ports.shrink_to_fit();
  program_->leaves.shrink_to_fit();
  program_->guards.shrink_to_fit();
  program_->info.shrink_to_fit();
  program_->layout.slots.shrink_to_fit();
}

}  // namespace coppice
