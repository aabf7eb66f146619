// The run of a real tree on simulated time, with leaves that do what the test says.
#ifndef COPPICE_TESTS_EDITOR_TIMELINE_EXECUTED_RUN_H_
#define COPPICE_TESTS_EDITOR_TIMELINE_EXECUTED_RUN_H_

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "bt_core/data/value_bytes.h"
#include "bt_core/engine/executor.h"
#include "bt_core/frames/history.h"

namespace coppice::editor {

/// Trees with the leaves Do (an action) and Is (a condition), which return what `results` says for
/// their port `as`, or else SUCCESS. Do writes its port `count`: how often it was ticked.
class ExecutedTree {
 public:
  /// `trees`: <BehaviorTree> elements, the first one with the ID Main.
  explicit ExecutedTree(const std::string& trees) : executor(Make(trees), clock) {}

  void Tick(Duration step = std::chrono::milliseconds(100)) {
    executor.Tick();
    clock.Advance(step);
  }

  std::map<std::string, Status> results;
  SimulatedClock clock{std::chrono::seconds(1)};

 private:
  using Results = std::map<std::string, Status>;

  class Do final : public Leaf {
   public:
    static constexpr NodeCategory kCategory = NodeCategory::kAction;
    static constexpr const char* kDescription = "Does what it is told.";
    explicit Do(Results* results) : results_(*results) {}
    Input<std::string> as{this, "as", "what `results` calls it", ""};
    Output<int> count{this, "count", "how often it was ticked"};
    Status Tick(bool) override {
      count.Set(++count_);
      const auto found = results_.find(*as);
      return found == results_.end() ? Status::kSuccess : found->second;
    }
    void Halt() override {}

   private:
    Results& results_;
    int count_ = 0;
  };

  class Is final : public Leaf {
   public:
    static constexpr NodeCategory kCategory = NodeCategory::kCondition;
    static constexpr const char* kDescription = "Is what it is told.";
    explicit Is(Results* results) : results_(*results) {}
    Input<std::string> as{this, "as", "what `results` calls it", ""};
    Status Tick(bool) override {
      const auto found = results_.find(*as);
      return found == results_.end() ? Status::kSuccess : found->second;
    }
    void Halt() override {}

   private:
    Results& results_;
  };

  std::shared_ptr<const Program> Make(const std::string& trees) {
    auto registry = std::make_shared<Registry>();
    registry->Register<Do>("Do", &results);
    registry->Register<Is>("Is", &results);
    Diagnostics diagnostics;
    std::optional<Project> project = Project::FromText(
        R"(<root BTCPP_format="4" main_tree_to_execute="Main">)" + trees + "</root>", "test.xml",
        diagnostics);
    std::shared_ptr<const Program> program;
    if (project) {
      program =
          Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
    }
    if (!program) throw std::invalid_argument(diagnostics.ToString());
    return program;
  }

 public:
  Executor executor;
};

/// Hands what a tree does to a handler, as a history.
class Follow final : public TickSink {
 public:
  Follow(Executor& executor, HistoryHandler& handler) : executor_(executor), handler_(handler) {
    executor.AddSink(this);
    Begin(HistoryState::Cause::kBegin);
  }
  ~Follow() override { executor_.RemoveSink(this); }

  void OnTick(const TickEvents& events) override { handler_.OnTick(events); }
  void OnJump(const Executor&) override { Begin(HistoryState::Cause::kJump); }

  void Begin(HistoryState::Cause cause) {
    if (cause != HistoryState::Cause::kLost) {
      RunInfo info = BeginRun(executor_.clock());
      handler_.OnTree(DescribeTree(*executor_.shared_program(), std::move(info)));
    }
    HistoryState state;
    state.cause = cause;
    state.tick = executor_.ticks();
    state.time = executor_.clock().Now();
    state.statuses = executor_.statuses();
    for (const Slot& slot : executor_.blackboard()) {
      AppendValueBytes(slot.value, state.values.emplace_back());
    }
    handler_.OnState(state);
  }

 private:
  Executor& executor_;
  HistoryHandler& handler_;
};

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_TIMELINE_EXECUTED_RUN_H_
