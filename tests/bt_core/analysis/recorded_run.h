// Runs trees with scripted leaves and keeps their runs as a Recording, without a file.
#ifndef COPPICE_TESTS_BT_CORE_ANALYSIS_RECORDED_RUN_H_
#define COPPICE_TESTS_BT_CORE_ANALYSIS_RECORDED_RUN_H_

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "bt_core/analysis/recording.h"
#include "bt_core/data/value_bytes.h"
#include "bt_core/engine/executor.h"

namespace coppice {

/// Keeps what an executor does.
class Keeper final : public TickSink {
 public:
  explicit Keeper(Executor& executor) : executor_(executor) {
    executor.AddSink(this);
    Begin(HistoryState::Cause::kBegin);
  }
  ~Keeper() override { executor_.RemoveSink(this); }

  void OnTick(const TickEvents& events) override { run.OnTick(events); }
  void OnJump(const Executor&) override { Begin(HistoryState::Cause::kJump); }

  /// As if ticks had been lost before this.
  void Lose() { Begin(HistoryState::Cause::kLost); }

  Recording run;

 private:
  void Begin(HistoryState::Cause cause) {
    if (program_ != executor_.shared_program()) {
      program_ = executor_.shared_program();
      RunInfo info;
      info.start = executor_.clock().Now();
      run.OnTree(DescribeTree(*program_, std::move(info)));
    }
    HistoryState state;
    state.cause = cause;
    state.tick = executor_.ticks();
    state.time = executor_.clock().Now();
    state.statuses = executor_.statuses();
    for (const Slot& slot : executor_.blackboard()) {
      AppendValueBytes(slot.value, state.values.emplace_back());
    }
    run.OnState(state);
  }

  Executor& executor_;
  std::shared_ptr<const Program> program_;
};

inline std::shared_ptr<const Program> CompileText(const std::string& trees,
                                                  std::shared_ptr<Registry> registry) {
  Diagnostics diagnostics;
  const std::string xml =
      R"(<root BTCPP_format="4" main_tree_to_execute="Main">)" + trees + "</root>";
  std::optional<Project> project = Project::FromText(xml, "test.xml", diagnostics);
  std::shared_ptr<const Program> program;
  if (project) {
    program = Compile(std::make_shared<const Project>(*std::move(project)), std::move(registry),
                      diagnostics);
  }
  if (!program) throw std::invalid_argument(diagnostics.ToString() + xml);
  return program;
}

/// One tree that runs on simulated time.
struct RecordedRun {
  /// `trees`: <BehaviorTree> elements, the first one with the ID Main.
  explicit RecordedRun(const std::string& trees,
                       std::shared_ptr<Registry> registry = std::make_shared<Registry>(),
                       ExecutorOptions options = {})
      : program(CompileText(trees, std::move(registry))), executor(program, clock, options) {}

  void Tick(Duration step = std::chrono::milliseconds(100)) {
    executor.Tick();
    clock.Advance(step);
  }

  SimulatedClock clock{std::chrono::seconds(1)};
  std::shared_ptr<const Program> program;
  Executor executor;
  Keeper keeper{executor};
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_ANALYSIS_RECORDED_RUN_H_
