#include "bt_core/testing/scenario_player.h"

#include <utility>

#include "bt_core/testing/stand_in.h"

namespace coppice {
namespace {

Value UntypedValue(const KeyValue& given) {
  Value value;
  if (given.kind == KeyValue::Kind::kBool) {
    value.Set(given.text == "true");
  } else if (given.kind == KeyValue::Kind::kNumber) {
    if (!value.Parse(TypeOf<std::int64_t>(), given.text)) value.Parse(TypeOf<double>(), given.text);
  } else {
    value.Set(given.text);
  }
  return value;
}

std::vector<MockRule> WithoutPlaces(const std::vector<PlacedRule>& placed) {
  std::vector<MockRule> rules;
  for (const PlacedRule& one : placed) rules.push_back(one.rule);
  return rules;
}

}  // namespace

class ScenarioPlayer::KeepMessages : public TickSink {
 public:
  void OnTick(const TickEvents& events) override {
    for (NodeMessage& message : MessagesOf(events.words)) messages.push_back(std::move(message));
  }
  std::vector<NodeMessage> messages;
};

ScenarioPlayer::ScenarioPlayer(const Program& program, const std::vector<PlacedRule>& rules,
                               std::uint64_t seed)
    : clock_(std::chrono::seconds(1)),
      sink_(std::make_unique<KeepMessages>()),
      tree_(program, WithoutPlaces(rules), clock_, {true, seed}) {
  tree_.executor().AddSink(sink_.get());
}

ScenarioPlayer::~ScenarioPlayer() { tree_.executor().RemoveSink(sink_.get()); }

StepOutcome ScenarioPlayer::Play(const ScenarioStep& step) {
  StepOutcome outcome;
  for (const KeyValue& value : step.set) Set(value, outcome);
  for (const PlacedRule& placed : step.leaves) ChangeScript(placed, outcome);
  clock_.Advance(step.advance);
  sink_->messages.clear();
  tree_.TakeEvents();
  if (step.halt) {
    tree_.executor().Halt();
  } else {
    for (int i = 0; i < step.ticks; ++i) outcome.status = tree_.executor().Tick();
  }
  outcome.events = tree_.TakeEvents();
  outcome.messages = std::exchange(sink_->messages, {});
  return outcome;
}

void ScenarioPlayer::Reload(const Program& program, const std::vector<PlacedRule>& rules) {
  tree_.Reload(program, WithoutPlaces(rules));
}

std::vector<NodeIndex> ScenarioPlayer::UnplayedNodes() const {
  std::vector<NodeIndex> nodes = tree_.UnknownLeaves();
  const Program& program = tree_.program();
  for (const LeafRecord& record : program.leaves) {
    const Registry::Entry* entry = program.registry->Find(program.Id(record.node));
    if (!entry || IsPlayed(record.node) || !NeedsScript(*entry)) continue;
    nodes.push_back(record.node);
  }
  return nodes;
}

// By a script of its own or of a node above it.
bool ScenarioPlayer::IsPlayed(NodeIndex node) const {
  if (tree_.ScriptOf(node)) return true;
  return node > 0 && IsPlayed(tree_.program().info[node].parent);
}

void ScenarioPlayer::Set(const KeyValue& given, StepOutcome& outcome) {
  std::string hint;
  const SlotIndex slot = FindKey(tree_.program(), given.key, hint);
  const std::string what = "key \"" + given.key + "\"";
  if (slot == kNoSlot) {
    outcome.problems.push_back(
        {given.where, 0, what, "a key of the tree", "none" + (hint.empty() ? "" : ", " + hint)});
    return;
  }
  const Type* type = tree_.program().layout.slots[slot].type;
  Value value = ValueOf(given, type);
  if (value.has_value()) {
    tree_.executor().inbox()->Post(slot, 0, std::move(value));
  } else {
    outcome.problems.push_back(
        {given.where, 0, what, std::string("a value of type ") + type->name, given.text});
  }
}

void ScenarioPlayer::ChangeScript(const PlacedRule& placed, StepOutcome& outcome) {
  if (tree_.ChangeScript(placed.rule.pattern, placed.rule.script) > 0) return;
  outcome.problems.push_back(
      {placed.where, 0, "leaves",
       "a node with a script from the start that fits \"" + placed.rule.pattern + "\"", "none"});
}

SlotIndex FindKey(const Program& program, const std::string& key, std::string& hint) {
  const std::size_t slash = key.rfind('/');
  const std::string path = slash == std::string::npos ? "" : key.substr(0, slash);
  const std::string name = slash == std::string::npos ? key : key.substr(slash + 1);
  for (ScopeIndex scope{0}; scope < program.trees.size(); ++scope) {
    if (program.trees[scope].path != path) continue;
    const SlotIndex slot = program.layout.Find(scope, name);
    if (slot != kNoSlot) return slot;
  }
  std::vector<std::string> keys;
  for (SlotIndex slot{0}; slot < program.layout.slots.size(); ++slot) {
    std::string known = KeyPathOf(program, slot);
    if (!known.empty()) keys.push_back(std::move(known));
  }
  hint = DidYouMean(key, keys);
  return kNoSlot;
}

std::string KeyPathOf(const Program& program, SlotIndex slot) {
  const SlotDefinition& definition = program.layout.slots[slot];
  if (definition.key.empty()) return {};
  const std::string& instance = program.trees[definition.scope].path;
  return instance.empty() ? definition.key : instance + "/" + definition.key;
}

KeyValue::Kind KindOfText(const std::string& text) {
  if (text == "true" || text == "false") return KeyValue::Kind::kBool;
  Value number;
  return number.Parse(TypeOf<double>(), text) ? KeyValue::Kind::kNumber : KeyValue::Kind::kString;
}

Outcome CheckKeyValue(const Program& program, const KeyValue& given) {
  std::string hint;
  const SlotIndex slot = FindKey(program, given.key, hint);
  if (slot == kNoSlot) {
    return Problem{"the tree has no key \"" + given.key + "\"" + (hint.empty() ? "" : ", " + hint)};
  }
  const Type* type = program.layout.slots[slot].type;
  if (ValueOf(given, type).has_value()) return {};
  return Problem{"\"" + given.text + "\" is no value of type " + type->name};
}

Value ValueOf(const KeyValue& given, const Type* type) {
  if (!type) return UntypedValue(given);
  Value value;
  value.Parse(*type, given.text);
  return value;
}

}  // namespace coppice
