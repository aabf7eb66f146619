// recorded FILE: records a run, and asks the record what came of it.
#include <cstdio>

#include "bt_core/analysis/load_recording.h"
#include "bt_core/record/recorder.h"
#include "tree.h"

namespace {

void RunRecorded(const char* path) {
  coppice::SimulatedClock clock;
  coppice::Executor executor(CompileTree(), clock);
  coppice::EventStream stream(executor);
  coppice::Recorder recorder(stream, path, {{{"robot", "outside"}}});
  while (executor.Tick() == coppice::Status::kRunning) clock.Advance(std::chrono::seconds(1));
}

}  // namespace

int main(int, char** arguments) {
  RunRecorded(arguments[1]);
  coppice::Diagnostics diagnostics;
  const auto run = coppice::LoadRecording(arguments[1], diagnostics);
  std::fputs(diagnostics.ToString().c_str(), stderr);
  if (!run || !run->is_closed()) return 1;
  std::printf("%s after %d recorded ticks\n", ToString(run->ticks().back().result),
              static_cast<int>(run->ticks().size()));
  return 0;
}
