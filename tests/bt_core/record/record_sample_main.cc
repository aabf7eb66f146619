// Records a tree whose leaves act at random, in several files, and prints how the tree stands after
// every tick and halt: number, time, result, the statuses, and the bytes of the values as
// hexadecimal digits. For readers in other languages.
//
// usage: bt_core_record_sample FILE
#include <cstdio>
#include <string>

#include "bt_core/data/value_bytes.h"
#include "bt_core/record/recorder.h"
#include "tests/bt_core/frames/scripted_tree.h"

namespace coppice {
namespace {

std::string Hexadecimal(const std::string& bytes) {
  std::string text;
  for (const char byte : bytes) {
    text += "0123456789abcdef"[static_cast<unsigned char>(byte) >> 4];
    text += "0123456789abcdef"[static_cast<unsigned char>(byte) & 15];
  }
  return text;
}

/// Remembers the results, since only a sink hears of halts.
class Results : public TickSink {
 public:
  void OnTick(const TickEvents& events) override {
    std::printf("tick %llu %lld %d", static_cast<unsigned long long>(events.tick),
                static_cast<long long>(events.start.time_since_epoch().count()),
                static_cast<int>(events.result));
    std::printf("%s\n", events.result == Status::kIdle ? " halt" : "");
  }
};

void PrintState(const Executor& executor) {
  std::printf("state");
  for (const Status status : executor.statuses()) std::printf(" %d", static_cast<int>(status));
  for (const Slot& slot : executor.blackboard()) {
    std::string bytes;
    AppendValueBytes(slot.value, bytes);
    std::printf(" %s", Hexadecimal(bytes).c_str());
  }
  std::printf("\n");
}

void Sample(const std::string& path) {
  LeafScript script;
  SimulatedClock clock;
  Executor executor(ScriptedProgram(script), clock);
  EventStream stream(executor);
  RecorderOptions options;
  options.max_file_bytes = 20000;
  Recorder recorder(stream, path, options);
  Results results;
  executor.AddSink(&results);
  std::mt19937 random(17);
  for (int i = 0; i < 4000; ++i) {
    if (i == 2500) executor.Reload(OtherScriptedProgram(script));
    if (i % 500 == 0) recorder.Note(clock.Now(), "sample", std::to_string(i));
    TickAtRandom(random, script, clock, executor);
    PrintState(executor);
    if (i % 50 == 0) stream.Flush();
  }
  executor.RemoveSink(&results);
  std::fputs(recorder.Close().problem().c_str(), stderr);
}

}  // namespace
}  // namespace coppice

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  coppice::Sample(argv[1]);
}
