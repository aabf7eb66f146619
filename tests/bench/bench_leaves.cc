#include "tests/bench/bench_leaves.h"

#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

namespace coppice::bench {
namespace {

class CondOk : public Condition {
 public:
  static constexpr const char* kDescription = "Succeeds.";
  bool Check() override { return true; }
};

class CondFail : public Condition {
 public:
  static constexpr const char* kDescription = "Fails.";
  bool Check() override { return false; }
};

class ActOk : public SyncAction {
 public:
  static constexpr const char* kDescription = "Succeeds.";
  Status Run() override { return Status::kSuccess; }
};

class ActMostly : public SyncAction {
 public:
  static constexpr const char* kDescription = "Fails one time in a hundred.";
  Status Run() override { return random_() % 100 == 0 ? Status::kFailure : Status::kSuccess; }

  static void Seed() { random_.seed(5); }

 private:
  inline static std::minstd_rand random_;
};

class RunForever : public Action {
 public:
  static constexpr const char* kDescription = "Runs.";
  Status OnStart() override { return Status::kRunning; }
  Status OnRunning() override { return Status::kRunning; }
  void OnHalted() override {}
};

class CondPort : public Condition {
 public:
  static constexpr const char* kDescription = "Is the value below the threshold?";
  Input<double> value{this, "value", "which"};
  Input<double> threshold{this, "threshold", "limit"};
  bool Check() override { return *value < *threshold; }
};

class Reader : public SyncAction {
 public:
  static constexpr const char* kDescription = "Reads a port many times.";
  Input<double> value{this, "value", "which"};
  Input<int> count{this, "count", "how often"};
  Status Run() override {
    double sum = 0;
    for (int i = *count; i > 0; --i) {
      sum += *value;
      asm volatile("" ::: "memory");  // every round reads anew
    }
    return sum > 0 ? Status::kSuccess : Status::kFailure;
  }
};

class Writer : public SyncAction {
 public:
  static constexpr const char* kDescription = "Writes a port many times.";
  Output<double> value{this, "value", "which"};
  Input<int> count{this, "count", "how often"};
  Status Run() override {
    for (int i = *count; i > 0; --i) {
      value.Set(i);
      asm volatile("" ::: "memory");
    }
    return Status::kSuccess;
  }
};

void Post(Executor& executor, const char* key, Value value) {
  const SlotIndex slot = executor.program().layout.Find(kMainScope, key);
  if (slot != kNoSlot) executor.inbox()->Post(slot, 0, std::move(value));
}

}  // namespace

std::shared_ptr<const Registry> BenchRegistry() {
  static const std::shared_ptr<const Registry> all = [] {
    auto registry = std::make_shared<Registry>();
    registry->Register<CondOk>("CondOk");
    registry->Register<CondFail>("CondFail");
    registry->Register<ActOk>("ActOk");
    registry->Register<ActMostly>("ActMostly");
    registry->Register<RunForever>("RunForever");
    registry->Register<CondPort>("CondPort");
    registry->Register<Reader>("Reader");
    registry->Register<Writer>("Writer");
    return registry;
  }();
  return all;
}

std::shared_ptr<const Program> Load(const std::string& text) {
  Diagnostics diagnostics;
  std::optional<Project> project = Project::FromText(text, "bench.xml", diagnostics);
  if (!project) throw std::runtime_error(diagnostics.ToString());
  auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), BenchRegistry(), diagnostics);
  if (!program) throw std::runtime_error(diagnostics.ToString());
  return program;
}

Tree::Tree(const std::string& text, int sinks)
    : listeners(static_cast<std::size_t>(sinks)), executor(Load(text), clock) {
  ActMostly::Seed();  // every run is the same
  Post(executor, "battery", Value(80.0));
  Post(executor, "charging", Value(false));
  Post(executor, "counter", Value(std::int64_t{0}));
  for (IdleSink& sink : listeners) executor.AddSink(&sink);
  executor.Tick();
}

std::string ReadLoop(int count) {
  return R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Reader value="{battery}" count=")" +
         std::to_string(count) + "\"/></BehaviorTree></root>";
}

std::string WriteLoop(int count) {
  return R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Writer value="{battery}" count=")" +
         std::to_string(count) + "\"/></BehaviorTree></root>";
}

}  // namespace coppice::bench
