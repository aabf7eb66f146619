#include "tests/bench/watched.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "bt_core/live/server/live_tree.h"
#include "bt_core/record/recorder.h"
#include "tests/bench/bench_leaves.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

constexpr int kTicksPerRound = 100;

std::string TextOf(const WatchedCase& watched) {
  std::string text = FullTree(4, 1000);
  if (!watched.leaves_fail) return text;
  const std::string always = "<ActOk/>";
  for (std::size_t at = text.find(always); at != std::string::npos; at = text.find(always, at)) {
    text.replace(at, always.size(), "<ActMostly/>");
  }
  return text;
}

void TickAll(Tree& tree, EventStream& stream, int rounds) {
  for (int i = 0; i < rounds * kTicksPerRound; ++i) {
    tree.clock.Advance(std::chrono::milliseconds(100));
    tree.executor.Tick();
    stream.Flush();
  }
}

void Record(Tree& tree, EventStream& stream, int rounds) {
  const std::string path = "/tmp/coppice_bench_" + std::to_string(getpid()) + ".coppice";
  Recorder recorder(stream, path);
  TickAll(tree, stream, rounds);
  static_cast<void>(recorder.Close());
  std::filesystem::remove(path);
}

void Publish(Tree& tree, EventStream& stream, int rounds) {
  LiveTree live(stream, {}, [] {});
  stream.Add(live);
  TickAll(tree, stream, rounds);
  stream.Remove(live);
}

// Counts changes as live views see them.
class Counter : public TickSink {
 public:
  explicit Counter(const Executor& executor)
      : follower_(ShapeOf(executor.program()), executor.statuses()) {}
  void OnTick(const TickEvents& events) override {
    EventReader reader(events.words);
    for (Event event; reader.Next(event);) {
      follower_.Apply(event, [this](const StatusChange&) { ++changes; });
    }
  }
  double changes = 0;

 private:
  StatusFollower follower_;
};

}  // namespace

const std::vector<WatchedCase>& WatchedCases() {
  static const std::vector<WatchedCase> all = {
      {"nobody watches", Watcher::kNobody, false, 0},
      {"recorder", Watcher::kRecorder, false, 40},
      {"live view", Watcher::kLiveView, false, 50},
      {"nobody watches, 1 % fail", Watcher::kNobody, true, 0},
      {"recorder, 1 % fail", Watcher::kRecorder, true, 40},
      {"live view, 1 % fail", Watcher::kLiveView, true, 50},
  };
  return all;
}

const WatchedCase* FindWatchedCase(const std::string& name) {
  for (const WatchedCase& watched : WatchedCases()) {
    if (watched.name == name) return &watched;
  }
  return nullptr;
}

void Run(const WatchedCase& watched, int rounds) {
  Tree tree(TextOf(watched));
  EventStream stream(tree.executor);
  switch (watched.watcher) {
    case Watcher::kNobody:
      return TickAll(tree, stream, rounds);
    case Watcher::kRecorder:
      return Record(tree, stream, rounds);
    case Watcher::kLiveView:
      return Publish(tree, stream, rounds);
  }
}

double ChangesPerRound(const WatchedCase& watched) {
  Tree tree(TextOf(watched));
  Counter counter(tree.executor);
  constexpr int kRounds = 10;
  tree.executor.AddSink(&counter);
  for (int i = 0; i < kRounds * kTicksPerRound; ++i) tree.executor.Tick();
  tree.executor.RemoveSink(&counter);
  return counter.changes / kRounds;
}

}  // namespace coppice::bench
