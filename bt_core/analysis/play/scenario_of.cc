#include "bt_core/analysis/play/scenario_of.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bt_core/analysis/play/leaf_scripts.h"
#include "bt_core/analysis/play/scenario_models.h"
#include "bt_core/analysis/recorded_tree.h"
#include "bt_core/data/value_bytes.h"
#include "bt_core/frames/follower.h"
#include "bt_core/testing/scenario_player.h"
#include "bt_core/testing/scenario_writer.h"
#include "bt_core/testing/stand_in.h"

namespace coppice {
namespace {

std::string NumberOf(const Recording& run, std::size_t tick) {
  return std::to_string(run.ticks()[tick].number);
}

// The last place at or before `first` at which the tree was not in the midst of something; nothing,
// with the reason, if there is none.
std::optional<std::size_t> BeginOf(const Recording& run, std::size_t first,
                                   Diagnostics& diagnostics) {
  const Recording::Section* known = nullptr;
  for (const Recording::Section& section : run.sections()) {
    if (section.first_tick <= first && !(known && FollowsOn(section))) known = &section;
  }
  std::size_t begin = first;
  while (begin > known->first_tick && !IsCompleted(run.ticks()[begin - 1].result)) --begin;
  const std::vector<Status>& statuses = known->state.statuses;
  if (begin > known->first_tick || statuses.empty() || statuses[0] != Status::kRunning) {
    return begin;
  }
  diagnostics.Error({}, "what is known begins with tick " + NumberOf(run, begin) +
                            ", when the tree was in the midst of something: a scenario needs its "
                            "beginning");
  return std::nullopt;
}

// Whether nothing is missing between two places.
bool IsWhole(const Recording& run, std::size_t begin, std::size_t end, Diagnostics& diagnostics) {
  for (const Recording::Section& section : run.sections()) {
    if (section.first_tick <= begin || section.first_tick >= end || FollowsOn(section)) continue;
    diagnostics.Error({}, "something is missing before tick " + NumberOf(run, section.first_tick) +
                              ", or the tree was changed there: choose a part without that");
    return false;
  }
  return true;
}

// The recorded tree with stand-ins for what only the robot has.
RecordedTree TreeWithStandIns(const TreeDescription& description, Diagnostics& diagnostics) {
  RecordedTree tree = CompileRecorded(description, std::make_shared<Registry>(), diagnostics);
  if (!tree.program) return tree;
  const auto registry = ScenarioRegistry(*tree.project);
  return CompileRecorded(description, std::make_shared<Registry>(*registry), diagnostics);
}

using Results = std::vector<std::pair<NodeIndex, Status>>;

Results ResultsOf(EventWords words) {
  Results results;
  EventReader reader(words);
  for (Event event; reader.Next(event);) {
    if (event.is_result()) results.emplace_back(event.node(), event.status());
  }
  return results;
}

class KeepResults final : public TickSink {
 public:
  void OnTick(const TickEvents& events) override {
    for (const auto& result : ResultsOf(events.words)) results.push_back(result);
  }
  Results results;
};

class Maker {
 public:
  Maker(const Recording& run, RecordedTree tree, std::size_t begin)
      : run_(run), tree_(std::move(tree)), scripts_(tree_), begin_(begin) {}

  std::optional<Scenario> Make(std::size_t end, std::string name, Diagnostics& diagnostics) {
    const TickView before = run_.Before(begin_);
    ScenarioStep step;
    step.set = FirstKeys(before.values);
    HistoryState state;
    state.statuses = before.statuses;
    state.values = before.values;
    HistoryFollower follower(tree_.shape, state);
    Time last = run_.ticks()[begin_].start;
    for (std::size_t tick = begin_; tick < end; ++tick) {
      const TickEvents events = run_.EventsOf(tick);
      const bool runs = follower.status(kRootNode) == Status::kRunning;
      follower.Apply(events);
      scripts_.Read(events, step);
      step.halt =
          events.result == Status::kIdle && runs && follower.status(kRootNode) == Status::kIdle;
      if (events.result == Status::kIdle && !step.halt) continue;  // between two ticks
      step.advance = std::max(events.start - last, Duration(0));
      last = events.start;
      steps_.push_back(std::exchange(step, {}));
      expected_.push_back(ResultsOf(events.words));
      numbers_.push_back(events.tick);
    }
    if (steps_.empty()) diagnostics.Error({}, "there is no tick in this part");
    if (steps_.empty() || !DoesTheSame(diagnostics)) return std::nullopt;
    return RecordScenario(*tree_.program, scripts_.Rules(), steps_, std::move(name));
  }

 private:
  // Of keys that a fresh tree has not got, or other ones.
  std::vector<KeyValue> FirstKeys(const std::vector<std::string>& values) const {
    const ScenarioPlayer fresh(*tree_.program, scripts_.Rules());
    const Blackboard& blackboard = fresh.tree().executor().blackboard();
    std::vector<KeyValue> keys;
    for (SlotIndex i{0}; i < values.size(); ++i) {
      const SlotIndex slot = tree_.program_slots[i];
      if (slot == kNoSlot || FormOfValue(values[i]) == ValueForm::kEmpty) continue;
      KeyValue value = KeyValueOf(KeyPathOf(*tree_.program, slot), values[i]);
      const Value& present = blackboard[slot].value;
      if (value.key.empty() || (present.has_value() && present.Print() == value.text)) continue;
      keys.push_back(std::move(value));
    }
    return keys;
  }

  bool DoesTheSame(Diagnostics& diagnostics) const {
    ScenarioPlayer player(*tree_.program, scripts_.Rules());
    KeepResults played;
    player.tree().executor().AddSink(&played);
    bool same = true;
    for (std::size_t i = 0; i < steps_.size() && same; ++i) {
      played.results.clear();
      const StepOutcome outcome = player.Play(steps_[i]);
      std::string problem;
      if (!outcome.problems.empty()) {
        const Difference& first = outcome.problems[0];
        problem = first.what + ": expected " + first.expected + ", got " + first.got;
      } else if (played.results != expected_[i]) {
        problem = "the tree does not do the same with scripted leaves: " +
                  FirstDifferenceOf(expected_[i], played.results);
      }
      same = problem.empty();
      if (!same) diagnostics.Error({}, "tick " + std::to_string(numbers_[i]) + ": " + problem);
    }
    player.tree().executor().RemoveSink(&played);
    return same;
  }

  std::string FirstDifferenceOf(const Results& expected, const Results& got) const {
    std::size_t i = 0;
    while (i < expected.size() && i < got.size() && expected[i] == got[i]) ++i;
    const auto print = [this, i](const Results& results) {
      if (i >= results.size()) return std::string("nothing more");
      return "\"" + tree_.PathOf(results[i].first) + "\" returned " + ToString(results[i].second);
    };
    return "in the record " + print(expected) + ", now " + print(got);
  }

  const Recording& run_;
  const RecordedTree tree_;
  LeafScripts scripts_;
  const std::size_t begin_;
  std::vector<ScenarioStep> steps_;
  std::vector<Results> expected_;       // of each step
  std::vector<std::uint64_t> numbers_;  // of the ticks
};

}  // namespace

std::optional<RecordedScenario> ScenarioOf(const Recording& run, std::size_t first, std::size_t end,
                                           std::string name, Diagnostics& diagnostics) {
  end = std::min(end, run.ticks().size());
  if (first >= end) {
    diagnostics.Error({}, "there is no tick in this part");
    return std::nullopt;
  }
  const std::optional<std::size_t> begin = BeginOf(run, first, diagnostics);
  if (!begin || !IsWhole(run, *begin, end, diagnostics)) return std::nullopt;
  const TreeDescription& description = run.trees()[run.TreeOf(*begin)];
  Diagnostics problems;
  RecordedTree tree = TreeWithStandIns(description, problems);
  if (!tree.program) {
    diagnostics.Append(problems);
    diagnostics.Error({}, "the recorded tree cannot be played");
    return std::nullopt;
  }
  std::optional<Scenario> scenario =
      Maker(run, std::move(tree), *begin).Make(end, std::move(name), diagnostics);
  if (!scenario) return std::nullopt;
  const std::uint32_t document = description.nodes[0].document;
  return RecordedScenario{*std::move(scenario), description.documents[document].file,
                          description.main_tree, ModelsOfRecord(description), *begin};
}

}  // namespace coppice
