#include <algorithm>
#include <iostream>
#include <utility>

#include "behaviortree_cpp/bt_factory.h"
#include "behaviortree_cpp/utils/wildcards.hpp"
#include "bt_core/compat/tree_run.h"

namespace BT {

bool WildcardMatch(const std::string& text, StringView filter) {
  return wildcards_match(text, filter);
}

Tree::Tree() = default;

Tree::Tree(Tree&& other) noexcept = default;

Tree& Tree::operator=(Tree&& other) noexcept {
  if (this == &other) return *this;
  Tree old(std::move(*this));
  subtrees = std::move(other.subtrees);
  manifests = std::move(other.manifests);
  run_ = std::move(other.run_);
  uid_counter_ = other.uid_counter_;
  return *this;
}

Tree::~Tree() {
  try {
    haltTree();
  } catch (...) {
    std::cerr << "A tree is destroyed, and what watches it has thrown an exception\n";
  }
}

TreeNode* Tree::rootNode() const {
  if (subtrees.empty() || subtrees.front()->nodes.empty()) return nullptr;
  return subtrees.front()->nodes.front().get();
}

void Tree::haltTree() {
  if (run_) run_->Halt();
}

Blackboard::Ptr Tree::rootBlackboard() {
  return subtrees.empty() ? nullptr : subtrees.front()->blackboard;
}

void Tree::applyVisitor(const std::function<void(const TreeNode*)>& visitor) const {
  applyRecursiveVisitor(static_cast<const TreeNode*>(rootNode()), visitor);
}
void Tree::applyVisitor(const std::function<void(TreeNode*)>& visitor) {
  applyRecursiveVisitor(rootNode(), visitor);
}

std::shared_ptr<WakeUpSignal> Tree::wakeUpSignal() const {
  return run_ ? run_->wake_up() : nullptr;
}
void Tree::emitWakeUpSignal() {
  if (run_) run_->wake_up()->emitSignal();
}

bool Tree::sleep(std::chrono::system_clock::duration timeout) {
  if (!run_) return false;
  const coppice::Duration due = run_->UntilNextTick();
  if (due == coppice::Duration::zero()) return true;
  const coppice::Duration longest = std::chrono::duration_cast<coppice::Duration>(timeout);
  return run_->wake_up()->waitFor(std::min(due, longest)) || due < longest;
}

NodeStatus Tree::tickExactlyOnce() { return TickRoot(Ticks::kOne, std::chrono::milliseconds(0)); }
NodeStatus Tree::tickOnce() { return TickRoot(Ticks::kUntilQuiet, std::chrono::milliseconds(0)); }
NodeStatus Tree::tickWhileRunning(std::chrono::milliseconds sleep_time) {
  return TickRoot(Ticks::kUntilDone, sleep_time);
}

NodeStatus Tree::TickRoot(Ticks ticks, std::chrono::milliseconds sleep_time) {
  if (!run_) throw RuntimeError("Empty Tree");
  NodeStatus status = run_->Tick();
  while (status == NodeStatus::RUNNING && ticks != Ticks::kOne) {
    if (run_->UntilNextTick() != coppice::Duration::zero()) {
      if (ticks == Ticks::kUntilQuiet) return status;
      if (sleep_time.count() > 0) sleep(sleep_time);
    }
    status = run_->Tick();
  }
  if (isStatusCompleted(status)) run_->Halt();
  return status;
}

// ---- Visitors.

void applyRecursiveVisitor(const TreeNode* root_node,
                           const std::function<void(const TreeNode*)>& visitor) {
  if (!root_node) throw LogicError("One of the children of a DecoratorNode or ControlNode is null");
  visitor(root_node);
  if (const auto* control = dynamic_cast<const ControlNode*>(root_node)) {
    for (const TreeNode* child : control->children()) applyRecursiveVisitor(child, visitor);
  } else if (const auto* decorator = dynamic_cast<const DecoratorNode*>(root_node)) {
    if (decorator->child()) applyRecursiveVisitor(decorator->child(), visitor);
  }
}

void applyRecursiveVisitor(TreeNode* root_node, const std::function<void(TreeNode*)>& visitor) {
  const std::function<void(const TreeNode*)> wrapped = [&](const TreeNode* node) {
    visitor(const_cast<TreeNode*>(node));
  };
  applyRecursiveVisitor(static_cast<const TreeNode*>(root_node), wrapped);
}

namespace {

void Print(const TreeNode* node, int depth, std::ostream& stream) {
  for (int k = 0; k < depth; ++k) stream << "   ";
  stream << (node ? node->name() : "!nullptr!") << std::endl;
  if (const auto* control = dynamic_cast<const ControlNode*>(node)) {
    for (const TreeNode* child : control->children()) Print(child, depth + 1, stream);
  } else if (const auto* decorator = dynamic_cast<const DecoratorNode*>(node)) {
    Print(decorator->child(), depth + 1, stream);
  }
}

}  // namespace

void printTreeRecursively(const TreeNode* root_node, std::ostream& stream) {
  stream << "----------------" << std::endl;
  Print(root_node, 0, stream);
  stream << "----------------" << std::endl;
}

void buildSerializedStatusSnapshot(const TreeNode* root_node,
                                   SerializedTreeStatus& serialized_buffer) {
  serialized_buffer.clear();
  applyRecursiveVisitor(root_node, [&](const TreeNode* node) {
    serialized_buffer.emplace_back(node->UID(), static_cast<uint8_t>(node->status()));
  });
}

const char* LibraryVersionString() { return "4.10.0"; }
int LibraryVersionNumber() { return 41000; }

// ---- Backups.

void BlackboardClone(const Blackboard& source, Blackboard& destination) {
  source.cloneInto(destination);
}

std::vector<Blackboard::Ptr> BlackboardBackup(const Tree& tree) {
  std::vector<Blackboard::Ptr> backup;
  for (const auto& subtree : tree.subtrees) {
    backup.push_back(Blackboard::create());
    subtree->blackboard->cloneInto(*backup.back());
  }
  return backup;
}

void BlackboardRestore(const std::vector<Blackboard::Ptr>& backup, Tree& tree) {
  if (backup.size() != tree.subtrees.size()) {
    throw LogicError("the backup is of another tree: it has another number of blackboards");
  }
  for (std::size_t k = 0; k < backup.size(); ++k) {
    backup[k]->cloneInto(*tree.subtrees[k]->blackboard);
  }
}

namespace {
const std::string& NameOf(const Tree::Subtree& subtree) {
  return subtree.instance_name.empty() ? subtree.tree_ID : subtree.instance_name;
}
}  // namespace

nlohmann::json ExportTreeToJSON(const Tree& tree) {
  nlohmann::json json;
  for (const auto& subtree : tree.subtrees) {
    json[NameOf(*subtree)] = ExportBlackboardToJSON(*subtree->blackboard);
  }
  return json;
}

void ImportTreeFromJSON(const nlohmann::json& json, Tree& tree) {
  if (json.size() != tree.subtrees.size()) {
    throw std::runtime_error("Number of blackboards don't match:");
  }
  for (const auto& subtree : tree.subtrees) {
    const auto found = json.find(NameOf(*subtree));
    if (found != json.end()) ImportBlackboardFromJSON(*found, *subtree->blackboard);
  }
}

}  // namespace BT
