#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "bt_core/base/json.h"
#include "bt_core/testing/scenario.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

constexpr char kTree[] = R"(
<root BTCPP_format="4"><BehaviorTree ID="Main">
  <ReactiveFallback name="top">
    <Timeout msec="100"><Go name="a" goal="{g}"/></Timeout>
    <Repeat name="r" num_cycles="{n}"><Go name="b"/></Repeat>
  </ReactiveFallback>
</BehaviorTree></root>)";

class Unknown : public SyncAction {
 public:
  Status Run() override { return Status::kFailure; }
};

std::shared_ptr<const Program> CompileTree() {
  Diagnostics diagnostics;
  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<Unknown>(); });
  auto project = Project::FromText(kTree, "", diagnostics);
  return Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
}

}  // namespace

int FuzzScenario(std::string_view bytes) {
  static const std::shared_ptr<const Program> program = CompileTree();
  Diagnostics diagnostics;
  const std::optional<ScenarioSuite> suite = ParseScenarios(std::string(bytes), "", diagnostics);
  if (suite.has_value() == diagnostics.has_errors()) std::abort();
  if (!suite) return 0;
  std::size_t steps = 0;
  for (const Scenario& scenario : suite->scenarios) {
    for (const ScenarioStep& step : scenario.steps) steps += static_cast<std::size_t>(step.ticks);
    if (steps > 1000) return 1;  // it would only take long
    RunScenario(*program, *suite, scenario);
  }
  return 2;
}

}  // namespace coppice::fuzz
