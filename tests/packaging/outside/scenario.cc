// Plays a scenario that holds, and one that does not.
#include "bt_core/testing/scenario.h"

#include <cstdio>

#include "tree.h"

namespace {

constexpr char kScenarios[] = R"({"tree": "tree.xml", "scenarios": [
  {"name": "it sleeps", "steps": [
    {"expect": {"status": "RUNNING", "blackboard": {"n": 3}}},
    {"advance_ms": 2000, "expect": {"status": "SUCCESS"}}]},
  {"name": "it does not", "steps": [{"expect": {"status": "SUCCESS"}}]}]})";

}  // namespace

int main() {
  coppice::Diagnostics diagnostics;
  const auto suite = coppice::ParseScenarios(kScenarios, "scenario.cc", diagnostics);
  std::fputs(diagnostics.ToString().c_str(), stderr);
  if (!suite) return 1;
  const auto program = CompileTree();
  for (const coppice::Scenario& scenario : suite->scenarios) {
    const auto result = coppice::RunScenario(*program, *suite, scenario);
    std::printf("%s: %d differences\n", scenario.name.c_str(),
                static_cast<int>(result.differences.size()));
  }
  return 0;
}
