// Plays a scenario with a shipped tree: the real tree, the real leaves, the real executor,
// simulated time, and a robot that remembers what it was asked.
#ifndef COPPICE_TESTS_TREES_TREE_SCENARIO_H_
#define COPPICE_TESTS_TREES_TREE_SCENARIO_H_

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/executor.h"
#include "bt_core/engine/node_hooks.h"
#include "bt_nodes/monitoring/health.h"
#include "bt_nodes/power/battery_reading.h"
#include "tests/bt_nodes/fakes.h"
#include "tests/support/folders.h"

namespace coppice {

class TreeScenario {
 public:
  /// `file` is relative to trees/; an empty tree ID is the main tree.
  explicit TreeScenario(const std::string& file, const std::string& tree = {}) {
    auto registry = std::make_shared<Registry>();
    leaves::RegisterNodes(*registry, robot.capabilities());
    Diagnostics diagnostics;
    program_ = CompileFile(SourceFolder() + "/trees/" + file, registry, diagnostics, tree);
    if (!program_) throw std::runtime_error(diagnostics.ToString());
    executor_ = std::make_unique<Executor>(program_, clock_);
    for (NodeIndex node{0}; node < program_->nodes.size(); ++node) {
      nodes_.emplace(program_->Name(node), node);
    }
  }

  leaves::FakeRobot robot;

  template <class T>
  void Set(const std::string& key, const T& value) {
    executor_->Writer<T>(key).Send(value);
  }

  /// A report with one entry for each (monitor, node) that is an error now; no argument: all is
  /// well.
  void Report(const std::vector<std::pair<std::string, std::string>>& errors = {}) {
    leaves::Health health;
    health.stamp = clock_.Now();
    for (const auto& [monitor, node] : errors) {
      health.entries.push_back({monitor, node, node, leaves::HealthLevel::kError, "broken"});
    }
    Set("monitoring", health);
  }

  Status Tick() { return executor_->Tick(); }
  void Halt() { executor_->Halt(); }
  Time now() const { return clock_.Now(); }
  void Advance(double seconds) {
    clock_.Advance(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds)));
  }
  /// Lets the robot's last action end, and ticks.
  Status Answer(bool ok) {
    robot.done.Send({ok, ok ? "" : "failed"});
    return Tick();
  }

  /// Status of the node with that name; throws if there is none.
  Status StatusOf(const std::string& name) const { return executor_->status(IndexOf(name)); }
  bool Runs(const std::string& name) const { return StatusOf(name) == Status::kRunning; }

  std::string LastCall() const { return robot.calls.empty() ? "" : robot.calls.back(); }
  long CallsOf(const std::string& call) const {
    return std::count(robot.calls.begin(), robot.calls.end(), call);
  }
  /// Number of calls that begin with the text.
  long CallsBeginning(const std::string& text) const {
    return std::count_if(robot.calls.begin(), robot.calls.end(),
                         [&](const std::string& call) { return call.rfind(text, 0) == 0; });
  }

  /// From the next tick on, the names of these nodes in the order in which a tick looks at them.
  void Follow(const std::vector<std::string>& names) {
    std::vector<NodeIndex> nodes;
    for (const std::string& name : names) nodes.push_back(IndexOf(name));
    executor_->SetHooks(&order_, nodes);
  }
  /// Of the last tick.
  std::vector<std::string> Followed() const {
    std::vector<std::string> names;
    for (const NodeIndex node : order_.nodes) names.push_back(program_->Name(node));
    return names;
  }

  Executor& executor() { return *executor_; }

 private:
  struct Order : NodeHooks {
    void BeforeTick() override { nodes.clear(); }
    std::optional<Status> Before(NodeIndex node) override {
      nodes.push_back(node);
      return std::nullopt;
    }
    std::optional<Status> After(NodeIndex, Status) override { return std::nullopt; }
    std::vector<NodeIndex> nodes;
  };

  NodeIndex IndexOf(const std::string& name) const {
    const auto found = nodes_.find(name);
    if (found == nodes_.end()) throw std::invalid_argument("no node \"" + name + "\"");
    return found->second;
  }

  std::shared_ptr<const Program> program_;
  std::map<std::string, NodeIndex> nodes_;  // by name; of namesakes the first
  Order order_;
  SimulatedClock clock_{std::chrono::seconds(1000)};
  std::unique_ptr<Executor> executor_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_TREES_TREE_SCENARIO_H_
