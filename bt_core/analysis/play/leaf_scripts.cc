#include "bt_core/analysis/play/leaf_scripts.h"

#include <algorithm>
#include <variant>

#include "bt_core/data/value_bytes.h"
#include "bt_core/testing/scenario_player.h"
#include "bt_core/testing/scenario_writer.h"
#include "bt_core/testing/stand_in.h"

namespace coppice {
namespace {

bool IsPlayed(const Program& program, NodeIndex node) {
  const Registry::Entry* entry = program.registry->Find(program.Id(node));
  return entry && IsStandIn(*entry);
}

// An infinite number is a text: JSON has none.
KeyValue::Kind KindOf(const std::string& bytes, const std::string& text) {
  const PlainValue value = ReadPlainValue(bytes);
  if (std::holds_alternative<bool>(value)) return KeyValue::Kind::kBool;
  const bool is_number =
      !std::holds_alternative<std::monostate>(value) && !std::holds_alternative<std::string>(value);
  return is_number && text.find_first_not_of("+-.0123456789e") == std::string::npos
             ? KeyValue::Kind::kNumber
             : KeyValue::Kind::kString;
}

}  // namespace

KeyValue KeyValueOf(std::string key, const std::string& bytes) {
  std::string text = PrintValueBytes(bytes);
  const KeyValue::Kind kind = KindOf(bytes, text);
  return {{}, std::move(key), std::move(text), kind};
}

LeafScripts::LeafScripts(const RecordedTree& tree) : tree_(tree) {
  const Program& program = *tree.program;
  for (const LeafRecord& record : program.leaves) {
    if (!IsPlayed(program, record.node)) continue;
    Leaf leaf;
    leaf.pattern = PatternOf(program, record.node);
    leaf.first.results = {Status::kSuccess};
    leaves_.emplace(record.node, std::move(leaf));
  }
}

void LeafScripts::Read(const TickEvents& events, ScenarioStep& step) {
  EventReader reader(events.words);
  for (Event event; reader.Next(event);) {
    if (event.code == EventCode::kWrite) {
      ReadWrite(event, step);
    } else if (event.code == EventCode::kDelivery) {
      Set(event.slot(), std::string(event.bytes), step);
    } else if (const auto leaf = leaves_.find(event.node());
               event.is_result() && leaf != leaves_.end()) {
      ReadResult(leaf->second, event.status());
    }
  }
  for (auto& [node, leaf] : leaves_) EndTick(leaf, step);
}

// What built-in nodes write they write again; a guard of a leaf too, at no port of it.
void LeafScripts::ReadWrite(const Event& event, ScenarioStep& step) {
  const auto leaf = leaves_.find(event.writer);
  const std::string bytes(event.bytes);
  if (leaf == leaves_.end()) {
    const bool is_users =
        event.writer == kNoNode || (event.writer < tree_.program->nodes.size() &&
                                    tree_.program->nodes[event.writer].type == NodeType::kUser);
    if (is_users) Set(event.slot(), bytes, step);
    return;
  }
  const std::string port = OutputOf(event.writer, event.slot());
  if (!port.empty()) leaf->second.written.emplace_back(port, PrintValueBytes(bytes));
}

void LeafScripts::ReadResult(Leaf& leaf, Status result) {
  leaf.of_tick.results.push_back(result);
  auto written = std::exchange(leaf.written, {});
  (result == Status::kRunning ? leaf.of_tick.feedback : leaf.of_tick.outputs) = std::move(written);
}

void LeafScripts::EndTick(Leaf& leaf, ScenarioStep& step) {
  MockScript script = std::exchange(leaf.of_tick, {});
  if (script.results.empty()) return;
  const Status last = script.results.back();
  const bool is_one = std::all_of(script.results.begin(), script.results.end(),
                                  [last](Status result) { return result == last; });
  if (is_one) script.results = {last};
  const bool goes_on = leaf.known && is_one && script.results == leaf.now.results &&
                       script.outputs == leaf.now.outputs && script.feedback == leaf.now.feedback;
  if (goes_on) return;
  leaf.now = script;
  leaf.now.results = {last};
  if (std::exchange(leaf.known, true)) {
    step.leaves.push_back({{}, {leaf.pattern, std::move(script)}});
  } else {
    leaf.first = std::move(script);
  }
}

// Slots of other things than keys cannot be written from outside.
void LeafScripts::Set(SlotIndex recorded_slot, const std::string& bytes, ScenarioStep& step) const {
  const SlotIndex slot = tree_.program_slots[recorded_slot];
  if (slot == kNoSlot || bytes.empty() || FormOfValue(bytes) == ValueForm::kEmpty) return;
  KeyValue value = KeyValueOf(KeyPathOf(*tree_.program, slot), bytes);
  if (value.key.empty()) return;
  const auto same = [&](const KeyValue& other) { return other.key == value.key; };
  step.set.erase(std::remove_if(step.set.begin(), step.set.end(), same), step.set.end());
  step.set.push_back(std::move(value));
}

std::string LeafScripts::OutputOf(NodeIndex node, SlotIndex recorded_slot) const {
  const Registry::Entry* entry = tree_.program->info[node].entry;
  for (const DescribedPort& port : tree_.description->nodes[node].ports) {
    if (port.slot != recorded_slot || !entry) continue;
    for (const PortDeclaration& declaration : entry->declarations) {
      if (declaration.name == port.name && declaration.direction != PortDirection::kInput) {
        return port.name;
      }
    }
  }
  return {};
}

std::vector<PlacedRule> LeafScripts::Rules() const {
  std::vector<PlacedRule> rules;
  for (const auto& [node, leaf] : leaves_) rules.push_back({{}, {leaf.pattern, leaf.first}});
  return rules;
}

}  // namespace coppice
