#include "bt_core/compat/tree_maker.h"

#include <deque>
#include <utility>

#include "bt_core/compat/built_ins.h"
#include "bt_core/compat/shell.h"
#include "bt_core/engine/program.h"
#include "bt_core/model/keys.h"

namespace BT::internal {

using coppice::NodeIndex;
using coppice::Program;
using coppice::SlotIndex;
using Rule = BehaviorTreeFactory::SubstitutionRule;

namespace {

// A copy in which some nodes are leaves that take the place of what the text says.
struct PatchedProgram : Program {
  explicit PatchedProgram(const Program& program) : Program(program) {}
  std::deque<coppice::Registry::Entry> entries;
};

bool IsOfUser(const Program& program, NodeIndex node) {
  return coppice::IsUserNode(program.nodes[node].type);
}

template <class Condition, std::size_t count>
void TakeConditions(const std::array<std::string, count>& names, const std::string& attribute,
                    const std::string& value, std::map<Condition, std::string>& conditions) {
  for (std::size_t k = 0; k < count; ++k) {
    if (names[k] == attribute) conditions[static_cast<Condition>(k)] = value;
  }
}

}  // namespace

TreeMaker::TreeMaker(const Making& making, std::shared_ptr<const Program> program,
                     Blackboard::Ptr main_board)
    : making_(making), program_(std::move(program)), main_board_(std::move(main_board)) {}

std::unique_ptr<TreeRun> TreeMaker::Make(
    std::vector<Tree::Subtree::Ptr>& subtrees,
    const std::unordered_map<std::string, TreeNodeManifest>& manifests) {
  Substitute();
  run_ = std::make_unique<TreeRun>(program_);
  MakeBoards(subtrees, main_board_);
  AttachKeys();
  for (NodeIndex node{0}; node < program_->nodes.size(); ++node) AddNode(node, manifests);
  for (std::size_t k = 0; k < program_->nodes.size(); ++k) {
    const auto node = static_cast<NodeIndex>(k);
    subtrees[static_cast<std::size_t>(program_->info[node].scope)]->nodes.push_back(
        run_->nodes()[k]);
  }
  return std::move(run_);
}

void TreeMaker::Substitute() {
  rules_.assign(program_->nodes.size(), nullptr);
  bool any = false;
  for (NodeIndex node{0}; node < program_->nodes.size(); ++node) {
    const bool is_subtree = program_->nodes[node].type == coppice::NodeType::kSubTree;
    rules_[node] = making_.rule(program_->Name(node), is_subtree ? "SubTree" : program_->Id(node),
                                program_->Path(node));
    any |= rules_[node] != nullptr;
  }
  if (!any) return;
  auto patched = std::make_shared<PatchedProgram>(*program_);
  for (NodeIndex node{0}; node < patched->nodes.size(); ++node) {
    if (!rules_[node]) continue;
    coppice::NodeRecord& record = patched->nodes[node];
    const std::uint32_t first_port = patched->FirstPort(node);
    coppice::Registry::Entry entry = *patched->info[node].entry;
    entry.build = &MakeBareShell;
    entry.tick = ShellTick();
    entry.declarations.clear();
    patched->entries.push_back(std::move(entry));
    patched->info[node].entry = &patched->entries.back();
    if (!IsOfUser(*patched, node)) {
      record.first_port = static_cast<std::uint32_t>(patched->leaves.size());
      patched->leaves.push_back({node, first_port});
    }
    if (record.dispatch == record.type) record.dispatch = coppice::NodeType::kLeaf;
    record.type = coppice::NodeType::kLeaf;
  }
  program_ = std::move(patched);
}

void TreeMaker::MakeBoards(std::vector<Tree::Subtree::Ptr>& subtrees, Blackboard::Ptr main_board) {
  for (std::size_t k = 0; k < program_->trees.size(); ++k) {
    const coppice::TreeInstance& instance = program_->trees[k];
    auto subtree = std::make_shared<Tree::Subtree>();
    subtree->tree_ID = instance.id;
    subtree->instance_name = instance.path;
    if (k == 0) {
      subtree->blackboard = main_board;
    } else {
      const auto outer = static_cast<std::size_t>(program_->info[instance.node].scope);
      subtree->blackboard = Blackboard::create(boards_[outer]);
      const coppice::StartTag tag = program_->TagOf(instance.node);
      subtree->blackboard->enableAutoRemapping(coppice::IsAutoremapped(tag));
      PortsRemapping given;
      for (const auto& [name, value] : tag.attributes) {
        if (!coppice::IsReservedAttribute(name)) given.emplace(name, value);
      }
      for (const auto& [name, value] : given) {
        const std::string_view key = coppice::KeyOf(value, name);
        if (!key.empty()) subtree->blackboard->addSubtreeRemapping(name, key);
      }
    }
    subtree->blackboard->setPolymorphicCastRegistry(making_.factory.polymorphicCastRegistryPtr());
    boards_.push_back(subtree->blackboard);
    subtrees.push_back(std::move(subtree));
  }
}

void TreeMaker::AttachKeys() {
  const std::vector<coppice::SlotDefinition>& slots = program_->layout.slots;
  cells_.resize(slots.size());
  for (std::size_t k = 0; k < slots.size(); ++k) {
    if (slots[k].key.empty()) continue;
    const auto scope = static_cast<std::size_t>(slots[k].scope);
    std::shared_ptr<Cell>& cell = cells_[k];
    cell = scope == 0 ? boards_[0]->MakeCell(slots[k].key) : boards_[scope]->OwnCell(slots[k].key);
    run_->Attach(cell, static_cast<SlotIndex>(k));
    if (slots[k].type && !cell->info.isStronglyTyped()) {
      cell->info = InfoOf(slots[k].type);
      cell->is_declared = true;
    }
  }
}

void TreeMaker::AddNode(NodeIndex node,
                        const std::unordered_map<std::string, TreeNodeManifest>& manifests) {
  const bool is_subtree = program_->nodes[node].type == coppice::NodeType::kSubTree;
  const auto found = manifests.find(is_subtree ? "SubTree" : program_->Id(node));
  const TreeNodeManifest* const manifest = found == manifests.end() ? nullptr : &found->second;
  const NodeConfig config = ConfigOf(node, manifest);
  if (IsOfUser(*program_, node)) Declare(node, manifest, config);
  std::vector<PortLink> links = LinksOf(node, manifest);
  TreeNode::Ptr made = MakeNode(node, config);
  JoinToParent(node, *made);
  if (IsOfUser(*program_, node)) Fill(run_->executor().user_node(node), *made, *run_);
  run_->Add(std::move(made), std::move(links));
}

NodeConfig TreeMaker::ConfigOf(NodeIndex node, const TreeNodeManifest* manifest) const {
  NodeConfig config;
  config.blackboard = boards_[static_cast<std::size_t>(program_->info[node].scope)];
  config.enums = making_.enums;
  config.manifest = manifest;
  config.uid = static_cast<uint16_t>(static_cast<std::uint32_t>(node) + 1);
  config.path = program_->Path(node);
  const bool is_subtree = manifest && manifest->type == NodeType::SUBTREE;
  const coppice::StartTag tag = program_->TagOf(node);
  for (const auto& [name, value] : tag.attributes) {
    TakeConditions(PreCondNames, std::string(name), std::string(value), config.pre_conditions);
    TakeConditions(PostCondNames, std::string(name), std::string(value), config.post_conditions);
    if (!IsAllowedPortName(name)) {
      if (!BT::IsReservedAttribute(name)) config.other_attributes[std::string(name)] = value;
      continue;
    }
    if (is_subtree) config.input_ports[std::string(name)] = value;
    if (!manifest) continue;
    const auto port = manifest->ports.find(std::string(name));
    if (port == manifest->ports.end()) continue;
    const PortDirection direction = port->second.direction();
    if (direction != PortDirection::OUTPUT) config.input_ports[port->first] = value;
    if (direction != PortDirection::INPUT) config.output_ports[port->first] = value;
  }
  if (!manifest) return config;
  for (const auto& [name, port] : manifest->ports) {
    const std::string& text = port.defaultValueString();
    if (text.empty()) continue;
    if (port.direction() != PortDirection::OUTPUT) config.input_ports.emplace(name, text);
    if (port.direction() != PortDirection::INPUT && TreeNode::isBlackboardPointer(text)) {
      config.output_ports.emplace(name, text);
    }
  }
  return config;
}

std::vector<PortLink> TreeMaker::LinksOf(NodeIndex node, const TreeNodeManifest* manifest) {
  std::vector<PortLink> links;
  const coppice::Registry::Entry* const entry = program_->info[node].entry;
  if (!entry || !manifest || !IsOfUser(*program_, node)) return links;
  for (std::size_t k = 0; k < entry->declarations.size(); ++k) {
    const coppice::PortDeclaration& declared = entry->declarations[k];
    const SlotIndex index = program_->ports[program_->FirstPort(node) + k].slot;
    if (index == coppice::kNoSlot) continue;
    const PortInfo& port = manifest->ports.at(declared.name);
    const bool reads = port.direction() != PortDirection::OUTPUT;
    const bool writes = port.direction() != PortDirection::INPUT;
    coppice::Slot& slot = run_->executor().blackboard()[index];
    const std::shared_ptr<Cell>& cell = cells_[static_cast<std::size_t>(index)];
    if (!cell && reads) ReadLiteral(node, declared.name, port, slot);
    PortLink link{declared.name, reads ? &slot : nullptr, nullptr, {}};
    // If another tree has the key, this one writes its own copy.
    if (writes && cell && cell->slot == &slot) link.output = cell;
    links.push_back(std::move(link));
  }
  return links;
}

// What the XML gives is read once, here.
void TreeMaker::ReadLiteral(NodeIndex node, const std::string& name, const PortInfo& port,
                            coppice::Slot& slot) {
  if (!port.isStronglyTyped()) return;
  const std::string text = slot.value.Get<std::string>();
  if (port.enum_reader()) return ReadEnum(port, text, slot);
  if (!port.converter()) return;
  try {
    slot.value = port.converter()(text).value();
  } catch (const std::exception& error) {
    const coppice::SourceLocation at = program_->Location(node);
    throw LogicError(StrCat(at.file, ":", std::to_string(at.line), ":", std::to_string(at.column),
                            ": The port with name \"", name, "\" and value \"", text,
                            "\" can not be converted to ", port.typeName(), ": ", error.what()));
  }
}

// A name that scripts do not know yet stays a text: it may be registered before it is read.
void TreeMaker::ReadEnum(const PortInfo& port, const std::string& text, coppice::Slot& slot) const {
  try {
    slot.value = port.enum_reader()(text, making_.enums.get()).value();
  } catch (const std::exception&) {
  }
}

void TreeMaker::Declare(NodeIndex node, const TreeNodeManifest* manifest,
                        const NodeConfig& config) {
  if (!manifest) return;
  const coppice::StartTag tag = program_->TagOf(node);
  for (const auto& [name, value] : tag.attributes) {
    const auto port = manifest->ports.find(std::string(name));
    if (port == manifest->ports.end()) continue;
    const auto key = TreeNode::getRemappedKey(name, value);
    if (!key) continue;
    std::shared_ptr<Cell> cell = config.blackboard->FindCell(*key);
    if (!cell) cell = config.blackboard->MakeCell(*key);
    DeclarePort(port->second, *cell, std::string(*key));
  }
}

void TreeMaker::DeclarePort(const PortInfo& port, Cell& cell, const std::string& key) {
  if (!cell.exists() || !cell.info.isStronglyTyped()) {
    cell.info = port;
    cell.is_declared = true;
    return;
  }
  const std::type_index before = cell.info.type();
  const bool same = !port.isStronglyTyped() || before == port.type();
  // What a built-in node reads is converted when it is written.
  const bool is_converted = cell.demanded && port.type() == typeid(std::string);
  const bool is_text = before == typeid(std::string) || is_converted;
  const bool is_related =
      port.direction() == PortDirection::INPUT &&
      making_.factory.polymorphicCastRegistry().isConvertible(before, port.type());
  if (same || is_text || is_related) return;
  throw RuntimeError("The creation of the tree failed because the port [", key,
                     "] was initially created with type [", demangle(before), "] and, later type [",
                     demangle(port.type()), "] was used somewhere else.");
}

TreeNode::Ptr TreeMaker::MakeNode(NodeIndex node, const NodeConfig& config) {
  const std::string name = program_->Name(node);
  const bool is_subtree = program_->nodes[node].type == coppice::NodeType::kSubTree;
  const std::string id = is_subtree ? "SubTree" : program_->Id(node);
  TreeNode::Ptr made = making_.factory.instantiateTreeNode(name, id, config);
  if (auto* const subtree = dynamic_cast<SubTreeNode*>(made.get())) {
    subtree->setSubtreeID(program_->Id(node));
  }
  return made;
}

void TreeMaker::JoinToParent(NodeIndex node, TreeNode& made) {
  if (node == coppice::kRootNode) return;
  const NodeIndex parent = program_->info[node].parent;
  TreeNode* const above = run_->nodes()[parent].get();
  if (auto* const control = dynamic_cast<ControlNode*>(above)) control->addChild(&made);
  if (auto* const decorator = dynamic_cast<DecoratorNode*>(above)) decorator->setChild(&made);
}

}  // namespace BT::internal
