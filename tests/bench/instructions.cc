#include "tests/bench/instructions.h"

#include <cstdio>
#include <cstring>
#include <memory>

#include "bt_core/engine/events/event_stream.h"
#include "tests/bench/bench_leaves.h"
#include "tests/bench/tree_texts.h"
#include "tests/bench/workloads.h"

namespace coppice::bench {
namespace {

// Of one run under callgrind, or nothing.
std::optional<double> Instructions(const std::string& program, const std::string& name,
                                   int rounds) {
  // Of the ticking thread alone, what it does in ticks.
  const std::string only = name == "script" ? "" : "'--toggle-collect=coppice::Executor::Tick()' ";
  const std::string command = "valgrind --tool=callgrind --callgrind-out-file=/dev/null " + only +
                              program + " --case '" + name + "' " + std::to_string(rounds) +
                              " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) return std::nullopt;
  char line[512];
  while (std::fgets(line, sizeof(line), pipe.get())) {
    double count = 0;
    const char* found = std::strstr(line, "Collected : ");
    if (found && std::sscanf(found, "Collected : %lf", &count) == 1) return count;
  }
  return std::nullopt;
}

void RunScripts(int rounds) {
  Tree tree(SequenceOf(1, "<ActOk" + Attribute("_skipIf", "battery > 20 && !charging") + "/>"));
  const Script& script = tree.executor.program().scripts.at(0);
  Blackboard blackboard = tree.executor.blackboard();
  for (int i = 0; i < rounds * 1000; ++i) script.Test(blackboard);
}

}  // namespace

std::optional<double> InstructionsPerRound(const std::string& program, const std::string& name) {
  constexpr int kRounds = 10;
  const auto one = Instructions(program, name, 1);
  const auto many = Instructions(program, name, 1 + kRounds);
  if (!one || !many) return std::nullopt;
  return (*many - *one) / kRounds;
}

int RunCase(const std::string& name, int rounds) {
  if (name == "script") {
    RunScripts(rounds);
    return 0;
  }
  const Workload& workload = FindWorkload(name);
  Tree tree(workload.text, workload.sinks);
  EventStream stream(tree.executor);
  IdleListener listener;
  if (workload.streams) stream.Add(listener);
  for (int i = 0; i < rounds; ++i) tree.executor.Tick();
  if (workload.streams) stream.Remove(listener);
  return 0;
}

}  // namespace coppice::bench
