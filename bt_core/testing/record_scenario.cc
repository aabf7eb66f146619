// What was played becomes what is expected.
#include <algorithm>
#include <utility>

#include "bt_core/testing/scenario_player.h"
#include "bt_core/testing/scenario_writer.h"

namespace coppice {
namespace {

std::vector<std::string> ValuesOf(const Executor& executor) {
  std::vector<std::string> values;
  for (const Slot& slot : executor.blackboard()) {
    values.push_back(slot.value.has_value() ? slot.value.Print() : std::string());
  }
  return values;
}

// A number or a boolean is written as such, so that it is one where the key has no type.
KeyValue::Kind KindOf(const Value& value) {
  if (value.type() == &TypeOf<bool>()) return KeyValue::Kind::kBool;
  const bool number = value.type() == &TypeOf<std::int64_t>() || value.type() == &TypeOf<int>() ||
                      value.type() == &TypeOf<double>();
  const std::string text = value.Print();
  return number && text.find_first_not_of("-.0123456789") == std::string::npos
             ? KeyValue::Kind::kNumber
             : KeyValue::Kind::kString;
}

class Recorder {
 public:
  Recorder(const Program& program, const std::vector<PlacedRule>& leaves, std::uint64_t seed)
      : program_(program), player_(program, leaves, seed), values_(ValuesOf(executor())) {}

  ScenarioStep Record(const ScenarioStep& played) {
    StepOutcome outcome = player_.Play(played);
    ScenarioStep step = played;
    step.expect = {};
    if (!step.halt && step.ticks > 0) step.expect.status = ExpectedStatus{{}, "", outcome.status};
    ExpectedEvents events;
    for (const LeafEvent& event : outcome.events) events.events.push_back(Expect(event));
    step.expect.events = std::move(events);
    step.expect.blackboard = ChangedKeys(step);
    return step;
  }

 private:
  const Executor& executor() { return player_.tree().executor(); }

  ExpectedEvent Expect(const LeafEvent& event) const {
    ExpectedEvent expected;
    expected.halted = event.halted;
    expected.leaf = PatternOf(program_, event.node);
    if (!event.halted) expected.status = event.result;
    return expected;
  }

  // What the tree wrote, not what the step itself sets.
  std::vector<ExpectedValue> ChangedKeys(const ScenarioStep& step) {
    std::vector<std::string> values = ValuesOf(executor());
    std::vector<ExpectedValue> changed;
    for (SlotIndex slot{0}; slot < values.size(); ++slot) {
      const std::string key = KeyPathOf(program_, slot);
      const Value& value = executor().blackboard()[slot].value;
      const bool is_set = std::any_of(step.set.begin(), step.set.end(),
                                      [&](const KeyValue& set) { return set.key == key; });
      if (key.empty() || is_set || !value.has_value() || values[slot] == values_[slot]) continue;
      ExpectedValue& expected = changed.emplace_back();
      expected.value.key = key;
      expected.value.text = values[slot];
      expected.value.kind = KindOf(value);
    }
    values_ = std::move(values);
    return changed;
  }

  const Program& program_;
  ScenarioPlayer player_;
  std::vector<std::string> values_;  // per slot
};

bool IsSame(const ExpectedEvent& a, const ExpectedEvent& b) {
  return a.halted == b.halted && a.leaf == b.leaf && a.status == b.status;
}

// Nothing is done to the tree but that time passes, and it does what it did in the step before.
bool IsQuiet(const ScenarioStep& step, const ScenarioStep& before) {
  const auto& events = step.expect.events->events;
  const auto& others = before.expect.events->events;
  return step.set.empty() && step.leaves.empty() && !step.halt && !before.halt &&
         step.expect.blackboard.empty() && step.expect.status && before.expect.status &&
         step.expect.status->status == before.expect.status->status &&
         std::equal(events.begin(), events.end(), others.begin(), others.end(), IsSame);
}

// Of a row of quiet steps the last one stays, with the time of all.
std::vector<ScenarioStep> Shorten(const std::vector<ScenarioStep>& steps) {
  std::vector<ScenarioStep> shorter;
  Duration skipped{0};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_quiet = i > 0 && IsQuiet(steps[i], steps[i - 1]);
    if (is_quiet && i + 1 < steps.size()) {
      skipped += steps[i].advance;
      continue;
    }
    shorter.push_back(steps[i]);
    shorter.back().advance += std::exchange(skipped, Duration(0));
  }
  return shorter;
}

}  // namespace

std::string PatternOf(const Program& program, NodeIndex node) {
  const std::string name = program.Name(node);
  std::size_t namesakes = 0;
  for (NodeIndex i{0}; i < program.nodes.size(); ++i) {
    if (program.Name(i) == name) ++namesakes;
  }
  if (namesakes == 1 && name.find_first_of("/*<") == std::string::npos) return name;
  const std::string path = program.Path(node);
  return path.find('/') == std::string::npos ? "/" + path : path;
}

Scenario RecordScenario(const Program& program, const std::vector<PlacedRule>& leaves,
                        const std::vector<ScenarioStep>& steps, std::string name,
                        std::uint64_t seed) {
  Scenario scenario;
  scenario.name = std::move(name);
  scenario.seed = seed;
  scenario.leaves = leaves;
  Recorder recorder(program, leaves, seed);
  for (const ScenarioStep& step : steps) scenario.steps.push_back(recorder.Record(step));

  Scenario shorter = scenario;
  shorter.steps = Shorten(scenario.steps);
  const bool passes = RunScenario(program, {}, shorter).differences.empty();
  return passes ? shorter : scenario;
}

}  // namespace coppice
