// How large records are, how fast they are written and how fast one finds a place in them.
//
//   coppice_record_bench [FOLDER]     needs some hundred megabytes there; default /tmp
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "bt_core/record/record_cursor.h"
#include "bt_core/record/recorder.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

using Stopwatch = std::chrono::steady_clock;

double Milliseconds(Stopwatch::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

/// A leaf that mostly succeeds, now and then fails, and writes what it has measured.
class Noisy : public SyncAction {
 public:
  static constexpr const char* kDescription = "Fails now and then.";
  explicit Noisy(double failures) : failures_(failures) {}
  Status Run() override {
    return std::uniform_real_distribution<>()(random_) < failures_ ? Status::kFailure
                                                                   : Status::kSuccess;
  }

 private:
  const double failures_;
  static std::mt19937 random_;
};
std::mt19937 Noisy::random_{5};

class Measuring : public SyncAction {
 public:
  static constexpr const char* kDescription = "Writes a number.";
  Output<double> value{this, "value", "what is measured"};
  Status Run() override {
    value.Set(0.001 * ++count_);
    return Status::kSuccess;
  }

 private:
  int count_ = 0;
};

std::shared_ptr<const Program> CompileNoisy(const std::string& xml, double failures) {
  auto registry = std::make_shared<Registry>();
  registry->Register<Noisy>("CondOk", failures);
  registry->Register<Noisy>("ActOk", failures);
  registry->Register<Measuring>("Measure");
  Diagnostics diagnostics;
  auto project = Project::FromText(xml, "bench.xml", diagnostics);
  auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
  if (!program) std::fputs(diagnostics.ToString().c_str(), stderr);
  return program;
}

/// Counts what goes by.
class Counter : public EventListener {
 public:
  void OnState(const StreamState& state) override {
    follower_.emplace(ShapeOf(*state.program), HistoryState{{}, 0, {}, state.statuses, {}, {}});
  }
  void OnTick(const TickEvents& tick) override {
    follower_->Apply(
        tick, [&](const StatusChange&) { ++changes; }, [&](const Event&) { ++events; });
  }
  std::uint64_t changes = 0;
  std::uint64_t events = 0;

 private:
  std::optional<HistoryFollower> follower_;
};

struct Run {
  std::string name;
  std::string xml;
  double failures;
  std::uint64_t events;
  bool slow;  ///< every tick is flushed by itself, as at 10 Hz
};

// Forgets the frames, but counts their bytes.
class Scale : public FrameSink {
 public:
  void OnFrame(const Frame& frame) override { bytes += frame.size; }
  std::uint64_t bytes = 0;
};

class Weigher : public EventListener {
 public:
  void OnState(const StreamState& state) override { encoder_.Add(state); }
  void OnTick(const TickEvents& tick) override {
    encoder_.Add(tick);
    encoder_.Flush();
  }
  std::uint64_t bytes() const { return scale_.bytes; }

 private:
  Scale scale_;
  HistoryEncoder encoder_{{}, scale_};
};

void Tick(const Run& run, SimulatedClock& clock, Executor& executor, EventStream& stream,
          const Counter& counter, std::mt19937& random) {
  while (counter.events < run.events) {
    for (int i = 0; i < 20; ++i) {
      clock.Advance(std::chrono::microseconds(100000 - 50 + random() % 100));
      executor.Tick();
    }
    stream.Flush();
  }
}

void MeasureFlushedTicks(const Run& run) {
  SimulatedClock clock;
  Executor executor(CompileNoisy(run.xml, run.failures), clock);
  EventStream stream(executor);
  Counter counter;
  Weigher weigher;
  stream.Add(counter);
  stream.Add(weigher);
  std::mt19937 random(1);
  Tick(run, clock, executor, stream, counter, random);
  stream.Remove(counter);
  stream.Remove(weigher);
  std::printf("%-28s %9llu events, one frame per tick: %6.2f B per tick, %5.2f B per change\n",
              run.name.c_str(), static_cast<unsigned long long>(counter.events),
              static_cast<double>(weigher.bytes()) / static_cast<double>(executor.ticks()),
              static_cast<double>(weigher.bytes()) / static_cast<double>(counter.changes));
}

void MeasureSeeks(const RecordReader& record) {
  std::mt19937_64 random(3);
  RecordCursor cursor(record);
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t tick = random() % record.last_tick() + 1;
    const auto start = Stopwatch::now();
    cursor.SeekTick(tick);
    times.push_back(Milliseconds(Stopwatch::now() - start));
    if (cursor.state().tick() != tick) std::printf("tick %llu was not found\n", 0ull + tick);
  }
  std::sort(times.begin(), times.end());
  std::printf("  seek: median %.2f ms, p99 %.2f ms, worst %.2f ms\n", times[1000], times[1980],
              times.back());
}

void MeasureRecord(const Run& run, const std::string& folder) {
  const std::string path = folder + "/coppice_bench.coppice";
  std::filesystem::remove(path);
  SimulatedClock clock;
  Executor executor(CompileNoisy(run.xml, run.failures), clock);
  EventStream stream(executor);
  Counter counter;
  stream.Add(counter);
  auto recorder = std::make_unique<Recorder>(stream, path);
  std::mt19937 random(1);
  const auto begin = Stopwatch::now();
  Tick(run, clock, executor, stream, counter, random);
  const std::string problem = recorder->Close().problem();
  const double writing = Milliseconds(Stopwatch::now() - begin);
  stream.Remove(counter);
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  std::printf(
      "%-28s %9llu events, %llu changes, %.1f MB, %.3f B per change; written in %.0f ms %s\n",
      run.name.c_str(), static_cast<unsigned long long>(counter.events),
      static_cast<unsigned long long>(counter.changes), size * 1e-6,
      size / static_cast<double>(counter.changes), writing, problem.c_str());

  const auto opening = Stopwatch::now();
  Diagnostics diagnostics;
  const auto record = RecordReader::Open(path, diagnostics);
  std::printf("  open: %.1f ms, %zu states\n", Milliseconds(Stopwatch::now() - opening),
              record->keyframes().size());
  MeasureSeeks(*record);
  const auto reading = Stopwatch::now();
  RecordCursor cursor(*record);
  while (cursor.Next() != RecordItem::kNone) {
  }
  std::printf("  all of it: %.0f ms\n", Milliseconds(Stopwatch::now() - reading));
  std::filesystem::remove(path);
}

std::string Monitor() {
  return R"(<root BTCPP_format="4"><BehaviorTree ID="Monitor"><ReactiveSequence>
    <Measure value="{battery}"/><CondOk/><CondOk/>
    <Fallback><Inverter><CondOk/></Inverter><ActOk/></Fallback><ActOk/>
  </ReactiveSequence></BehaviorTree></root>)";
}

void Main(const std::string& folder) {
  const std::string full = FullTree(4, 1000);
  std::string writing = R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence>)";
  for (int i = 0; i < 100; ++i) {
    writing += "<Measure value=\"{v" + std::to_string(i) + "}\"/>";
  }
  writing += "</Sequence></BehaviorTree></root>";
  MeasureFlushedTicks({"monitor, steady", Monitor(), 0, 100000, true});
  MeasureFlushedTicks({"monitor, 5 % fail", Monitor(), 0.05, 100000, true});
  MeasureFlushedTicks({"full_4ary_1000, 1 % fail", full, 0.01, 1000000, true});
  MeasureRecord({"full_4ary_1000, steady", full, 0, 10000000, false}, folder);
  MeasureRecord({"full_4ary_1000, 1 % fail", full, 0.01, 10000000, false}, folder);
  MeasureRecord({"full_4ary_1000, 50 % fail", full, 0.5, 10000000, false}, folder);
  MeasureRecord({"monitor, 5 % fail", Monitor(), 0.05, 10000000, false}, folder);
  MeasureRecord({"100 doubles per tick", writing, 0, 10000000, false}, folder);
}

}  // namespace
}  // namespace coppice::bench

int main(int argc, char** argv) { coppice::bench::Main(argc > 1 ? argv[1] : "/tmp"); }
