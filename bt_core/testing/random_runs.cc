#include "bt_core/testing/random_runs.h"

#include <algorithm>
#include <utility>

#include "bt_core/testing/default_leaves.h"
#include "bt_core/testing/mocked_tree.h"
#include "bt_core/testing/scenario_player.h"

namespace coppice {
namespace {

constexpr int kMostTicksAtOnce = 1000;
constexpr std::size_t kMostFindings = 100;

void Set(MockedTree& tree, const KeyValue& given) {
  const Program& program = tree.program();
  std::string hint;
  const SlotIndex slot = FindKey(program, given.key, hint);
  if (slot == kNoSlot) return;
  Value value = ValueOf(given, program.layout.slots[slot].type);
  if (value.has_value()) tree.executor().inbox()->Post(slot, 0, std::move(value));
}

}  // namespace

class RandomRuns::Watcher final : public TickSink {
 public:
  explicit Watcher(RandomRuns& runs) : runs_(runs) {}

  void OnTick(const TickEvents& events) override {
    EventReader reader(events.words);
    for (Event event; reader.Next(event);) {
      if (event.is_status()) {
        ++runs_.coverage_.nodes[event.index].results[static_cast<std::size_t>(event.status())];
      } else if (event.code == EventCode::kText && event.text == EventText::kException) {
        runs_.Find(runs_.program_->Path(event.node()), std::string(event.bytes), events.tick);
      }
    }
  }

 private:
  RandomRuns& runs_;
};

RandomRuns::RandomRuns(std::shared_ptr<const Program> program, RandomRunOptions options)
    : program_(std::move(program)), options_(std::move(options)) {
  for (PlacedRule& placed : RandomLeaves(*program_, options_.play.leaves)) {
    rules_.push_back(std::move(placed.rule));
  }
  coverage_.first_seed = options_.seed;
  for (NodeIndex node{0}; node < program_->nodes.size(); ++node) {
    coverage_.nodes.push_back({program_->Path(node), {}});
  }
}

void RandomRuns::Run() {
  SimulatedClock clock(std::chrono::seconds(1));
  Watcher watcher(*this);
  const std::uint64_t seed = options_.seed + coverage_.runs;
  MockedTree tree(*program_, rules_, clock, {false, seed});
  Executor& executor = tree.executor();
  executor.AddSink(&watcher);
  for (const PlacedRule& told : options_.scripts) {
    tree.ChangeScript(told.rule.pattern, told.rule.script);
  }
  for (const KeyValue& chosen : ChosenKeys(options_.play.set, seed)) Set(tree, chosen);
  for (const KeyValue& given : options_.set) Set(tree, given);
  Status status = Status::kRunning;
  const Time end = clock.Now() + options_.play.lasts;
  int at_once = 0;
  while ((!IsCompleted(status) || clock.Now() < end) && executor.ticks() < options_.most_ticks) {
    status = executor.Tick();
    tree.TakeEvents();
    if (executor.next_tick() > clock.Now()) {
      at_once = 0;
    } else if (++at_once < kMostTicksAtOnce) {
      continue;
    } else if (at_once == kMostTicksAtOnce) {
      Find("", "asks for the next tick at once, for ever", executor.ticks());
    }
    clock.Advance(options_.period);
  }
  executor.RemoveSink(&watcher);
  coverage_.ticks += executor.ticks();
  ++coverage_.results[static_cast<std::size_t>(status)];
  ++coverage_.runs;
}

void RandomRuns::Find(std::string node, std::string text, std::uint64_t tick) {
  std::vector<RandomFinding>& all = coverage_.findings;
  const auto same = std::find_if(all.begin(), all.end(), [&](const RandomFinding& other) {
    return other.node == node && other.text == text;
  });
  if (same != all.end()) {
    ++same->times;
  } else if (all.size() < kMostFindings) {
    all.push_back({std::move(node), std::move(text), 1, options_.seed + coverage_.runs, tick});
  }
}

std::vector<KeyValue> ChosenKeys(const std::vector<std::vector<KeyValue>>& choices,
                                 std::uint64_t seed) {
  std::vector<KeyValue> chosen;
  for (const std::vector<KeyValue>& choice : choices) {
    Dice dice(seed, choice.front().key);
    chosen.push_back(ChooseOne(choice, dice));
  }
  return chosen;
}

std::vector<std::string> NeverTicked(const Coverage& coverage) {
  std::vector<std::string> paths;
  for (const NodeCoverage& node : coverage.nodes) {
    if (node.ticks() == 0) paths.push_back(node.path);
  }
  return paths;
}

std::vector<std::string> NeverReturned(const Coverage& coverage, Status status) {
  std::vector<std::string> paths;
  for (const NodeCoverage& node : coverage.nodes) {
    if (node.ticks() > 0 && node.results_of(status) == 0) paths.push_back(node.path);
  }
  return paths;
}

}  // namespace coppice
