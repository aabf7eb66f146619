// Records a tree that ticks as fast as its recorder can follow, and writes the number of the newest
// tick that the recorder says is safe to its output, 8 bytes each, until it is killed.
//
// usage: bt_core_record_victim FILE
#include <unistd.h>

#include <thread>

#include "bt_core/record/recorder.h"
#include "tests/bt_core/frames/scripted_tree.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  coppice::LeafScript script;
  script.write = true;
  coppice::SimulatedClock clock;
  coppice::Executor executor(coppice::ScriptedProgram(script), clock);
  coppice::EventStream stream(executor);
  coppice::RecorderOptions options;
  options.flush_period = std::chrono::milliseconds(1);
  options.sync_period = std::chrono::milliseconds(5);
  options.max_file_bytes = 30000;
  const coppice::Recorder recorder(stream, argv[1], options);
  std::uint64_t reported = 0;
  while (true) {
    if (executor.ticks() - recorder.flushed_tick() < 5000) {
      script.number = static_cast<int>(executor.ticks());
      executor.Tick();
    } else {
      std::this_thread::yield();
    }
    const std::uint64_t flushed = recorder.flushed_tick();
    if (flushed == reported) continue;
    reported = flushed;
    if (write(STDOUT_FILENO, &reported, sizeof(reported)) != sizeof(reported)) return 1;
  }
}
