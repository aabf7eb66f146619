// Runs a tree with a leaf of its own on simulated time.
#include <cstdio>
#include <memory>

#include "bt_core/engine/executor.h"

using coppice::Status;

class CountDown : public coppice::Action {
 public:
  static constexpr const char* kDescription = "Runs for some ticks.";
  coppice::Input<int> from{this, "from", "how many ticks"};
  Status OnStart() override {
    left_ = *from;
    return OnRunning();
  }
  Status OnRunning() override { return --left_ > 0 ? Status::kRunning : Status::kSuccess; }
  void OnHalted() override {}

 private:
  int left_ = 0;
};

int main() {
  auto registry = std::make_shared<coppice::Registry>();
  registry->Register<CountDown>("CountDown");
  registry->Condition("IsSunny", [] { return true; });

  coppice::Diagnostics diagnostics;
  auto project = coppice::Project::FromText(
      R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
           <Sequence><IsSunny/><CountDown from="3"/></Sequence>
         </BehaviorTree></root>)",
      "main.cc", diagnostics);
  if (!project) return 1;
  const auto program = coppice::Compile(
      std::make_shared<const coppice::Project>(*std::move(project)), registry, diagnostics);
  std::fputs(diagnostics.ToString().c_str(), stderr);
  if (!program) return 1;

  coppice::SimulatedClock clock;
  coppice::Executor executor(program, clock);
  Status status = executor.Tick();
  while (status == Status::kRunning) status = executor.Tick();
  std::printf("%s after %d ticks\n", ToString(status), static_cast<int>(executor.ticks()));
  return 0;
}
