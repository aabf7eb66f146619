#include <atomic>
#include <csignal>
#include <iostream>
#include <memory>

#include "bt_core/base/command_line.h"
#include "bt_core/base/plain.h"
#include "bt_core/cli/live/live_view.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/events/status_follower.h"
#include "bt_core/engine/runner.h"
#include "bt_core/record/recorder.h"

namespace coppice {
namespace {

std::atomic<Runner*> running{nullptr};

void StopRunning(int) {
  if (Runner* runner = running) runner->RequestStop();
}

// Prints every change of status as it happens.
class Printer : public TickSink {
 public:
  explicit Printer(const Executor& executor)
      : program_(executor.program()), follower_(ShapeOf(program_), executor.statuses()) {}
  void OnTick(const TickEvents& events) override {
    EventReader reader(events.words);
    for (Event event; reader.Next(event);) {
      follower_.Apply(event, [&](const StatusChange& change) { Print(events.tick, change); });
    }
    for (const NodeMessage& message : MessagesOf(events.words)) {
      std::cout << "tick " << events.tick << "  " << Plain(program_.Path(message.node)) << ": "
                << Plain(message.text) << "\n";
    }
  }

 private:
  void Print(std::uint64_t tick, const StatusChange& change) const {
    if (change.to == Status::kIdle) return;
    std::cout << "tick " << tick << "  " << Plain(program_.Path(change.node)) << "  "
              << ToString(change.from) << " -> " << ToString(change.to) << "\n";
  }

  const Program& program_;
  StatusFollower follower_;
};

// The tree with everything around it, until its root completes.
int RunProgram(const std::shared_ptr<const Program>& program, const Options& options) {
  WallClock clock;
  Executor executor(program, clock);
  Printer printer(executor);
  if (!options.Has("--quiet")) executor.AddSink(&printer);
  EventStream stream(executor);
  std::optional<Recorder> recorder;
  if (options.Has("--record")) recorder.emplace(stream, options.Get("--record"));
  const LiveView live(stream, options, [&recorder](const HistoryNote& note) {
    if (recorder) recorder->Note(note.time, note.kind, note.text);
  });
  RunOptions run;
  run.forever = options.Has("--forever");
  Runner runner(executor, run);
  running = &runner;
  std::signal(SIGINT, StopRunning);
  std::signal(SIGTERM, StopRunning);
  const Status result = runner.Run();
  running = nullptr;
  std::cout << ToString(result) << "\n";
  const Outcome recorded = recorder ? recorder->Close() : Outcome();
  if (!recorded) std::cerr << recorded.problem() << "\n";
  return result == Status::kFailure || runner.stop_requested() || !recorded ? 1 : 0;
}

}  // namespace

const Command& RunCommand() {
  static const Command command{
      "coppice run",
      "run a tree of built-in nodes",
      {"FILE", 1, 1},
      R"(Runs a tree of built-in nodes and those of plugins until its root completes; Ctrl+C
halts it. Trees with the robot's leaves are run by coppice-robot.)",
      Together({CommandOption::Text("--tree", "ID", "which tree of the file; else the main one"),
                PluginOption(),
                CommandOption::Flag("--forever", "starts again when the root has completed"),
                CommandOption::Flag("--quiet", "prints the result only"),
                CommandOption::Text("--record", "OUT.coppice",
                                    "writes every tick into a file for coppice replay")},
               LiveViewOptions())};
  return command;
}

int RunTree(const Arguments& arguments) {
  const Options options = ParseOptions(RunCommand(), arguments);
  if (options.exit) return *options.exit;
  const std::shared_ptr<const Registry> registry = RegistryWithPlugins(options);
  if (!registry) return 2;
  Diagnostics diagnostics;
  const auto program = CompileFile(options.files[0], registry, diagnostics, options.Get("--tree"));
  std::cerr << diagnostics.ToString();
  if (!program) return 2;
  try {
    return RunProgram(program, options);
  } catch (const std::exception& error) {  // no such address, the record is there already
    std::cerr << error.what() << "\n";
    return 2;
  }
}

}  // namespace coppice
