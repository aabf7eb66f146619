#include <atomic>
#include <csignal>
#include <iostream>
#include <memory>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/runner.h"

namespace coppice {
namespace {

constexpr char kUsage[] =
    "coppice run FILE [--tree ID] [--plugin FILE.so]...\n"
    "  Runs a tree of built-in nodes and those of plugins until its root completes; Ctrl+C halts "
    "it.\n"
    "  Trees with the robot's leaves are run by coppice-robot.";

std::atomic<Runner*> running{nullptr};

void StopRunning(int) {
  if (Runner* runner = running) runner->RequestStop();
}

// Prints every change of status as it happens.
class Printer : public TickSink {
 public:
  explicit Printer(const Program& program) : program_(program) {}
  void OnTick(const TickEvents& events) override {
    for (const StatusChange& change : events.changes) {
      if (change.to == Status::kIdle) continue;
      std::cout << "tick " << events.tick << "  " << program_.Path(change.node) << "  "
                << ToString(change.from) << " -> " << ToString(change.to) << "\n";
    }
    for (const NodeMessage& message : events.messages) {
      std::cout << "tick " << events.tick << "  " << program_.Path(message.node) << ": "
                << message.text << "\n";
    }
  }

 private:
  const Program& program_;
};

}  // namespace

int RunTree(const Arguments& arguments) {
  const std::optional<Options> options =
      ParseOptions(arguments, {"--plugin", "--tree"}, {}, kUsage);
  if (!options) return 2;
  if (options->files.size() != 1) {
    std::cerr << "expected one file\nusage: " << kUsage << "\n";
    return 2;
  }
  const std::shared_ptr<const Registry> registry = RegistryWithPlugins(*options);
  if (!registry) return 2;
  Diagnostics diagnostics;
  const auto program =
      CompileFile(options->files[0], registry, diagnostics, options->Get("--tree"));
  std::cerr << diagnostics.ToString();
  if (!program) return 2;

  WallClock clock;
  Executor executor(program, clock);
  Printer printer(*program);
  executor.AddSink(&printer);
  Runner runner(executor);
  running = &runner;
  std::signal(SIGINT, StopRunning);
  std::signal(SIGTERM, StopRunning);
  const Status result = runner.Run();
  running = nullptr;
  std::cout << ToString(result) << "\n";
  return result == Status::kFailure || runner.stop_requested() ? 1 : 0;
}

}  // namespace coppice
