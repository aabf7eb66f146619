#include "bt_core/testing/mocked_tree.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "bt_core/data/literal.h"
#include "bt_core/model/keys.h"

namespace coppice {

// What is known of one leaf or played node.
struct MockedTree::Part {
  MockedTree& tree;
  NodeIndex node;
  NodeNames names;
  const Registry::Entry* original;  // null for a type that nobody registered
  bool of_user;                     // not built in
  std::uint32_t first_port;         // of Program::ports, if there is an original
  bool played;
  MockScript script;
  Dice dice;
  std::optional<std::size_t> next = 0;  // of the script's results; nothing: as before the reload
  bool begins = false;                  // the script is a new one, also for an activation that runs
};

// A copy in which the parts have entries of their own: those build what plays or watches the node.
class MockedTree::MockedProgram : public Program {
 public:
  explicit MockedProgram(const Program& program) : Program(program) {}
  std::deque<Registry::Entry> entries;
};

// A port of a played node; knows its type at run time only.
class MockedTree::MockPort final : public PortBase {
 public:
  explicit MockPort(const PortDeclaration& declaration)
      : PortBase(declaration), name_(declaration.name), type_(declaration.type) {}

  const std::string& name() const { return name_; }
  /// Without a type of port and key, a number is a number and true a truth value. `key_type`: what
  /// other ports give to the key; null if none does.
  void Write(const std::string& text, const Type* key_type) {
    if (!slot_) return;
    const Type* type = type_ ? type_ : key_type;
    Value value;
    if (!type) {
      value = UntypedValue(text);
    } else if (!value.Parse(*type, text)) {
      throw std::invalid_argument("\"" + text + "\" is not a value for output \"" + name_ +
                                  "\", expected " + type->name);
    }
    slot_->value = std::move(value);
    slot_->CountWrite(*now_);
  }

 private:
  static Value UntypedValue(const std::string& text) {
    Value value = GuessValue(text);
    if (text == "true" || text == "false") value.Set(text == "true");
    return value;
  }

  std::string name_;
  const Type* type_;
};

class MockedTree::PlayedNode : public Leaf {
 public:
  explicit PlayedNode(Part& part) : part_(&part) {
    if (!part.of_user || !part.original) return;
    for (const PortDeclaration& declaration : part.original->declarations) {
      ports_.emplace_back(declaration);
    }
  }

  Status Tick(bool starting) override {
    Part& part = Here();
    const bool is_new = std::exchange(part.begins, false);
    if (is_new || starting) Begin(part, is_new);
    const Status result = now() < done_at_ ? Waiting() : ResultNow(part);
    const bool throws = IsCompleted(result) && !part.script.throws.empty();
    part.tree.events_.push_back(
        {part.node, false, throws ? Status::kFailure : result, part.tree.InputsOf(part)});
    if (throws) throw std::runtime_error(part.script.throws);
    if (result == Status::kRunning) WriteOutputs(part, part.script.feedback);
    if (IsCompleted(result)) {
      WriteOutputs(part, part.script.outputs);
      WriteOutputsByChance(part);
      if (!part.script.says.empty()) Say(part.script.says);
    }
    return result;
  }

  void Halt() override {
    const Part& part = Here();
    part.tree.events_.push_back({part.node, true, Status::kIdle, {}});
  }

 private:
  // After a reload the node is another part of the tree; it goes on in its script.
  Part& Here() {
    Part& part = part_->tree.PartAt(host().current_node());
    if (!part.next) {
      part.next = part_->next.value_or(0);
      part.dice = part_->dice;
    }
    part_ = &part;
    return part;
  }

  void Begin(Part& part, bool is_new) {
    if (part.script.restart) part.next = 0;
    if (is_new || now() >= holds_until_) {
      drawn_ = part.script.chances ? Throw(*part.script.chances, part.dice)
                                   : DrawnResult{part.script.duration, Status::kIdle};
      holds_until_ = now() + drawn_.holds;
    }
    done_at_ = now() + drawn_.after;
  }

  Status Waiting() {
    WakeAt(done_at_);
    return Status::kRunning;
  }

  Status ResultNow(Part& part) const {
    return part.script.chances ? drawn_.result : NextResult(part);
  }

  static Status NextResult(Part& part) {
    const std::vector<Status>& results = part.script.results;
    if (results.empty()) return Status::kSuccess;
    const Status result = results[std::min(*part.next, results.size() - 1)];
    ++*part.next;
    return result;
  }

  void WriteOutputs(const Part& part, const Inputs& values) {
    for (const auto& [name, text] : values) WriteOutput(part, name, text);
  }

  void WriteOutputsByChance(Part& part) {
    for (const auto& [name, texts] : part.script.outputs_by_chance) {
      WriteOutput(part, name, ChooseOne(texts, part.dice));
    }
  }

  void WriteOutput(const Part& part, const std::string& name, const std::string& text) {
    const Program& program = *part.tree.program_;
    for (std::size_t k = 0; k < ports_.size(); ++k) {
      if (ports_[k].name() != name) continue;
      const SlotIndex slot = program.ports[part.first_port + k].slot;
      ports_[k].Write(text, slot == kNoSlot ? nullptr : program.layout.slots[slot].type);
      return;
    }
    throw std::invalid_argument("the scripted node has no port \"" + name + "\"");
  }

  Part* part_;
  std::deque<MockPort> ports_;
  Time done_at_{};
  DrawnResult drawn_;  // of this activation
  Time holds_until_{};
};

// A leaf that is itself, but for being written down.
class MockedTree::WatchedLeaf : public Leaf {
 public:
  WatchedLeaf(MockedTree& tree, std::unique_ptr<UserNode> leaf)
      : tree_(tree), leaf_(std::move(leaf)) {}

  void set_host(LeafHost* host) override {
    UserNode::set_host(host);
    leaf_->set_host(host);
  }
  Status Tick(bool starting) override {
    const Part& part = tree_.PartAt(host().current_node());
    std::vector<LeafEvent>& events = tree_.events_;
    events.push_back({part.node, false, Status::kFailure, tree_.InputsOf(part)});
    const Status result = leaf_->Tick(starting);
    events.back().result = result;  // a leaf that throws has failed
    return result;
  }
  void Halt() override {
    tree_.events_.push_back({host().current_node(), true, Status::kIdle, {}});
    leaf_->Halt();
  }
  bool HasStopped() override { return leaf_->HasStopped(); }

 private:
  MockedTree& tree_;
  std::unique_ptr<UserNode> leaf_;
};

MockedTree::MockedTree(const Program& program, std::vector<MockRule> rules, Clock& clock,
                       MockOptions options)
    : options_(options),
      rules_(std::move(rules)),
      program_(std::make_shared<MockedProgram>(program)) {
  parts_ = MakeParts(*program_);
  executor_ = std::make_unique<Executor>(program_, clock);
  events_.clear();
}

MockedTree::~MockedTree() = default;

MockedTree::Parts MockedTree::MakeParts(MockedProgram& program) {
  Parts parts;
  for (NodeIndex node{0}; node < program.nodes.size(); ++node) {
    const std::optional<std::size_t> rule =
        ChooseRule(rules_, {program.Name(node), program.Path(node), program.Id(node)});
    const bool is_leaf = program.nodes[node].type == NodeType::kLeaf;
    if (!rule && !is_leaf) continue;
    const NodeIndex end = program.nodes[node].end;
    parts.push_back(MakePart(program, node, rule ? &rules_[*rule].script : nullptr));
    if (rule) node = end - 1;  // what is below it is never ticked
  }
  return parts;
}

std::unique_ptr<MockedTree::Part> MockedTree::MakePart(MockedProgram& program, NodeIndex node,
                                                       const MockScript* script) {
  NodeRecord& record = program.nodes[node];
  NodeInfo& info = program.info[node];
  const bool of_user = record.type == NodeType::kLeaf || record.type == NodeType::kUser;
  const std::uint32_t first_port =
      of_user ? program.leaves[record.first_port].first_port : record.first_port;
  auto made =
      std::make_unique<Part>(Part{*this,
                                  node,
                                  {program.Name(node), program.Path(node), program.Id(node)},
                                  info.entry,
                                  of_user,
                                  first_port,
                                  script != nullptr,
                                  script ? *script : MockScript(),
                                  Dice(options_.seed, program.Path(node))});

  Registry::Entry entry = info.entry ? *info.entry : Registry::Entry();
  if (!of_user) entry.declarations.clear();  // what plays a built-in node has no ports
  entry.tick = &Registry::TickVirtually;
  entry.build = [&part = *made, original = info.entry,
                 registry = program.registry]() -> std::unique_ptr<UserNode> {
    if (part.played) return std::make_unique<PlayedNode>(part);
    if (original) return std::make_unique<WatchedLeaf>(part.tree, original->build());
    const PortCollector unused;  // nobody binds the ports of a leaf without an entry
    return std::make_unique<WatchedLeaf>(part.tree, registry->fallback()(part.names.name));
  };
  program.entries.push_back(std::move(entry));
  info.entry = &program.entries.back();

  if (record.dispatch == record.type) record.dispatch = NodeType::kLeaf;
  record.type = NodeType::kLeaf;
  if (!of_user) {
    record.first_port = static_cast<std::uint32_t>(program.leaves.size());
    program.leaves.push_back({node, first_port});
  }
  return made;
}

void MockedTree::Reload(const Program& program, std::vector<MockRule> rules) {
  rules_ = std::move(rules);
  const std::shared_ptr<MockedProgram> old = program_;  // until its nodes have moved
  auto next = std::make_shared<MockedProgram>(program);
  Parts parts = MakeParts(*next);
  for (const auto& part : parts) {
    part->next.reset();
    for (const MockRule& change : changes_) {
      if (part->played && Matches(change.pattern, part->names)) part->script = change.script;
    }
  }
  executor_->Reload(next);
  program_ = std::move(next);
  old_parts_.push_back(std::exchange(parts_, std::move(parts)));
}

MockedTree::Part& MockedTree::PartAt(NodeIndex node) {
  return **std::lower_bound(parts_.begin(), parts_.end(), node,
                            [](const auto& part, NodeIndex n) { return part->node < n; });
}

const MockScript* MockedTree::ScriptOf(NodeIndex node) const {
  for (const auto& part : parts_) {
    if (part->node == node && part->played) return &part->script;
  }
  return nullptr;
}

MockedTree::Inputs MockedTree::InputsOf(const Part& part) const {
  if (!options_.inputs) return {};
  return part.original ? InputsOfPorts(part) : InputsOfAttributes(part.node);
}

MockedTree::Inputs MockedTree::InputsOfPorts(const Part& part) const {
  Inputs inputs;
  for (std::size_t k = 0; k < part.original->declarations.size(); ++k) {
    const PortDeclaration& port = part.original->declarations[k];
    const SlotIndex slot = program_->ports[part.first_port + k].slot;
    const bool is_input =
        port.direction == PortDirection::kInput || port.direction == PortDirection::kInOut;
    if (!is_input || slot == kNoSlot) continue;
    const Value& value = executor_->blackboard()[slot].value;
    if (value.has_value()) inputs.emplace_back(port.name, value.Print());
  }
  return inputs;
}

// Of a node of a type that nobody declared: every attribute may be an input.
MockedTree::Inputs MockedTree::InputsOfAttributes(NodeIndex node) const {
  Inputs inputs;
  for (const auto& [name, value] : program_->TagOf(node).attributes) {
    if (IsReservedAttribute(name)) continue;
    const std::string_view key = KeyOf(value, name);
    if (key.empty()) {
      inputs.emplace_back(name, value);
      continue;
    }
    const SlotIndex slot = program_->layout.Find(program_->info[node].scope, key);
    if (slot == kNoSlot || !executor_->blackboard()[slot].value.has_value()) continue;
    inputs.emplace_back(name, executor_->blackboard()[slot].value.Print());
  }
  return inputs;
}

int MockedTree::ChangeScript(const std::string& pattern, const MockScript& script) {
  int changed = 0;
  changes_.push_back({pattern, script});
  for (const auto& part : parts_) {
    if (!part->played || !Matches(pattern, part->names)) continue;
    part->script = script;
    part->next = 0;
    part->begins = true;
    ++changed;
  }
  return changed;
}

std::vector<std::string> MockedTree::UnusedPatterns() const {
  std::vector<std::string> unused;
  for (const MockRule& rule : rules_) {
    const auto fits = [&](const auto& part) { return Matches(rule.pattern, part->names); };
    if (std::none_of(parts_.begin(), parts_.end(), fits)) unused.push_back(rule.pattern);
  }
  return unused;
}

std::vector<NodeIndex> MockedTree::UnknownLeaves() const {
  std::vector<NodeIndex> unknown;
  for (const auto& part : parts_) {
    if (!part->played && !part->original) unknown.push_back(part->node);
  }
  return unknown;
}

}  // namespace coppice
