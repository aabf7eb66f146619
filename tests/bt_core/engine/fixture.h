// Small helpers for the tests of the engine: compile a text, leaves that do as they are told, a
// sink that keeps what it gets.
#ifndef COPPICE_TESTS_BT_CORE_ENGINE_FIXTURE_H_
#define COPPICE_TESTS_BT_CORE_ENGINE_FIXTURE_H_

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/engine/events/status_follower.h"
#include "bt_core/engine/executor.h"
#include "bt_core/engine/program.h"

namespace coppice {

/// Has one port of each kind.
class Drive : public SyncAction {
 public:
  static constexpr const char* kDescription = "Drives.";
  Input<double> goal{this, "goal", "where to [m]"};
  Input<int> tries{this, "tries", "how often", 3};
  Input<std::string> label{this, "label", "for people", kOptional};
  Output<double> distance{this, "distance", "driven [m]"};
  InOut<int> total{this, "total", "sum of all drives"};
  Status Run() override {
    distance.Set(*goal * 2);
    total.Set((total.has_value() ? total.Get() : 0) + *tries);
    return Status::kSuccess;
  }
};

/// Writes a text.
class Tell : public SyncAction {
 public:
  static constexpr const char* kDescription = "Writes a text.";
  Input<std::string> text{this, "text", "what"};
  Output<std::string> to{this, "to", "where to"};
  Status Run() override {
    to.Set(*text);
    return Status::kSuccess;
  }
};

/// What the scripted leaves of a tree share: <Leaf name="x"/> returns the results of "x" in turn
/// and then repeats the last one.
struct LeafScript {
  std::map<std::string, std::vector<Status>> results;
  std::map<std::string, std::function<void()>> on_tick;
  std::map<std::string, std::function<void()>> on_halt;
  std::vector<std::string> events;  // "start x", "tick x", "halt x"
};

class ScriptedLeaf : public Leaf {
 public:
  ScriptedLeaf(LeafScript& script, std::string name) : script_(script), name_(std::move(name)) {}
  Status Tick(bool starting) override {
    script_.events.push_back((starting ? "start " : "tick ") + name_);
    if (script_.on_tick.count(name_)) script_.on_tick[name_]();
    const std::vector<Status>& results = script_.results[name_];
    if (results.empty()) return Status::kSuccess;
    return results[std::min(next_++, results.size() - 1)];
  }
  void Halt() override {
    script_.events.push_back("halt " + name_);
    if (script_.on_halt.count(name_)) script_.on_halt[name_]();
  }

 private:
  LeafScript& script_;
  std::string name_;
  std::size_t next_ = 0;
};

class KeepingSink : public TickSink {
 public:
  struct Kept {
    std::uint64_t tick;
    Time start;
    Status result;
    std::vector<StatusChange> changes;
    std::vector<SlotIndex> writes;
    std::vector<NodeMessage> messages;
  };
  /// Without it, the changes are not known.
  void Follow(const Executor& executor) {
    follower_.emplace(ShapeOf(executor.program()), executor.statuses());
  }
  void OnTick(const TickEvents& events) override {
    ticks.push_back({events.tick, events.start, events.result, {}, {}, MessagesOf(events.words)});
    EventReader reader(events.words);
    for (Event event; reader.Next(event);) Keep(event, ticks.back());
  }
  /// As they follow from the events.
  const std::vector<Status>& statuses() const { return follower_->statuses(); }
  std::vector<Kept> ticks;

 private:
  void Keep(const Event& event, Kept& tick) {
    if (event.code == EventCode::kWrite || event.code == EventCode::kDelivery) {
      tick.writes.push_back(event.slot());
    }
    if (!follower_) return;
    follower_->Apply(event, [&](const StatusChange& change) { tick.changes.push_back(change); });
  }

  std::optional<StatusFollower> follower_;
};

inline std::string Root(const std::string& trees) {
  return "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n" + trees + "\n</root>";
}
inline std::string Main(const std::string& body) {
  return Root("<BehaviorTree ID=\"Main\">\n" + body + "\n</BehaviorTree>");
}

inline std::shared_ptr<const Registry> TestRegistry() {
  auto registry = std::make_shared<Registry>();
  registry->Register<Drive>("Drive");
  registry->Register<Tell>("Tell");
  return registry;
}

/// Null if there are errors.
inline std::shared_ptr<const Program> CompileText(const std::string& text, Diagnostics& diagnostics,
                                                  std::shared_ptr<const Registry> registry,
                                                  const std::string& tree = {}) {
  auto project = Project::FromText(text, "t.xml", diagnostics);
  if (!project) return nullptr;
  return Compile(std::make_shared<const Project>(*std::move(project)), std::move(registry),
                 diagnostics, tree);
}

/// Runs a tree of scripted leaves, built-in nodes, Drive and Tell on simulated time.
struct Stage {
  explicit Stage(const std::string& text, LeafScript given = {}) : script(std::move(given)) {
    auto registry = std::make_shared<Registry>(*TestRegistry());
    registry->SetFallback(
        [this](const std::string& name) { return std::make_unique<ScriptedLeaf>(script, name); });
    Diagnostics diagnostics;
    program = CompileText(text, diagnostics, registry);
    if (!program) throw std::logic_error(diagnostics.ToString());
    executor = std::make_unique<Executor>(program, clock);
  }
  std::vector<std::string> TakeEvents() { return std::exchange(script.events, {}); }

  const KeepingSink& Listen() {
    sink.Follow(*executor);
    executor->AddSink(&sink);
    return sink;
  }

  LeafScript script;
  KeepingSink sink;  // before the executor, which reports to it until its end
  SimulatedClock clock{std::chrono::seconds(1)};
  std::shared_ptr<const Program> program;
  std::unique_ptr<Executor> executor;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_ENGINE_FIXTURE_H_
