#include "bt_core/analysis/why/readings.h"

#include <algorithm>

#include "bt_core/analysis/play/played_value.h"

namespace coppice {
namespace {

bool IsAtOrBelow(const TreeShape& shape, NodeIndex node, NodeIndex top) {
  return node >= top && node < shape[top].end;
}

std::string AttributeOf(const Program& program, NodeIndex node, std::string_view name) {
  return std::string(program.TagOf(node).Value(name));
}

void AddGuards(const RecordedTree& tree, NodeIndex node, std::vector<NodeScript>& scripts) {
  const Program& program = *tree.program;
  const auto guards = std::lower_bound(
      program.guards.begin(), program.guards.end(), node,
      [](const GuardRecord& record, NodeIndex wanted) { return record.node < wanted; });
  if (guards == program.guards.end() || guards->node != node) return;
  for (std::size_t i = 0; i < kGuardCount; ++i) {
    if (guards->scripts[i] == kNoScript) continue;
    const std::string_view name = kGuardAttributes[i];
    scripts.push_back({name, static_cast<Guard>(i), AttributeOf(program, node, name),
                       &program.scripts[guards->scripts[i]]});
  }
}

// The status that an answer of a guard stands for; IDLE: the node may be ticked.
Status ResultOf(Guard guard, bool answer) {
  switch (guard) {
    case Guard::kFailureIf:
      return answer ? Status::kFailure : Status::kIdle;
    case Guard::kSuccessIf:
      return answer ? Status::kSuccess : Status::kIdle;
    case Guard::kSkipIf:
      return answer ? Status::kSkipped : Status::kIdle;
    case Guard::kOnlyIf:
    case Guard::kWhile:
      return answer ? Status::kIdle : Status::kSkipped;
    default:
      return Status::kIdle;
  }
}

}  // namespace

SlotValues ValuesAt(const TickView& view, const Walk& walk, const TreeShape& shape,
                    StepIndex step) {
  const WalkStep& entered = walk.steps[step];
  SlotValues values = view.values;
  for (std::uint32_t i = 0; i < entered.event; ++i) {
    const Event& event = walk.events[i];
    if (event.code != EventCode::kWrite && event.code != EventCode::kDelivery) continue;
    const bool later = i >= entered.entry && event.code == EventCode::kWrite &&
                       (event.writer == kNoNode || IsAtOrBelow(shape, event.writer, entered.node));
    if (!later && event.index < values.size()) values[event.index] = event.bytes;
  }
  return values;
}

std::vector<Reading> PortReadings(const RecordedTree& tree, NodeIndex node) {
  std::vector<Reading> readings;
  if (!tree.program || !tree.program->info[node].entry) return readings;
  const Program& program = *tree.program;
  const std::uint32_t first = program.FirstPort(node);
  const auto& declarations = program.info[node].entry->declarations;
  for (std::size_t k = 0; k < declarations.size(); ++k) {
    const PortDeclaration& port = declarations[k];
    const SlotIndex slot = program.ports[first + k].slot;
    const bool reads =
        port.direction == PortDirection::kInput || port.direction == PortDirection::kInOut;
    if (!reads || slot == kNoSlot) continue;
    const SlotIndex recorded = tree.recorded_slots[slot];
    if (recorded == kNoSlot || program.layout.slots[slot].key.empty()) continue;
    readings.push_back({port.name, program.layout.slots[slot].key, recorded});
  }
  return readings;
}

std::vector<NodeScript> ScriptsOf(const RecordedTree& tree, NodeIndex node) {
  std::vector<NodeScript> scripts;
  if (!tree.program) return scripts;
  AddGuards(tree, node, scripts);
  const Registry::Entry* entry = tree.program->info[node].entry;
  if (!entry) return scripts;
  const std::uint32_t first = tree.program->FirstPort(node);
  for (std::size_t k = 0; k < entry->declarations.size(); ++k) {
    const PortDeclaration& port = entry->declarations[k];
    const ScriptIndex script = tree.program->ports[first + k].script;
    if (script == kNoScript) continue;
    scripts.push_back({port.name, std::nullopt, AttributeOf(*tree.program, node, port.name),
                       &tree.program->scripts[script]});
  }
  return scripts;
}

std::vector<Reading> ScriptReadings(const RecordedTree& tree, const NodeScript& script) {
  std::vector<Reading> readings;
  for (const SlotIndex slot : script.script->reads()) {
    const SlotIndex recorded = tree.recorded_slots[slot];
    const std::string& key = tree.program->layout.slots[slot].key;
    if (recorded != kNoSlot) readings.push_back({key, key, recorded});
  }
  return readings;
}

std::optional<bool> Test(const RecordedTree& tree, const NodeScript& script,
                         const SlotValues& values) {
  Blackboard blackboard = MakeBlackboard(tree.program->layout);
  for (const SlotIndex slot : script.script->reads()) {
    const SlotIndex recorded = tree.recorded_slots[slot];
    if (recorded == kNoSlot) continue;
    blackboard[slot].value = PlayedValue(values[recorded], tree.program->layout.slots[slot].type);
  }
  try {
    return script.script->Test(blackboard);
  } catch (const ScriptError&) {
    return std::nullopt;
  }
}

std::optional<GuardDecision> DecideGuards(const RecordedTree& tree, NodeIndex node, bool running,
                                          const SlotValues& values) {
  for (const NodeScript& script : ScriptsOf(tree, node)) {
    if (!script.guard || *script.guard > Guard::kWhile) continue;
    if (running && *script.guard != Guard::kWhile) continue;
    const std::optional<bool> answer = Test(tree, script, values);
    if (!answer) return std::nullopt;
    const Status result = ResultOf(*script.guard, *answer);
    if (result != Status::kIdle) return GuardDecision{script, *answer, result};
  }
  return std::nullopt;
}

}  // namespace coppice
