#include "tests/bench/instructions.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "bt_core/engine/events/event_stream.h"
#include "tests/bench/bench_leaves.h"
#include "tests/bench/tree_texts.h"
#include "tests/bench/watched.h"
#include "tests/bench/workloads.h"

namespace coppice::bench {
namespace {

// What is counted of it: a workload's ticks on the ticking thread alone, or all of the program.
bool IsWorkload(const std::string& name) {
  const auto& all = Workloads();
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

// Of one run of the command under callgrind, or nothing. Without `only` of all of it.
std::optional<double> Instructions(const std::string& command, const std::string& only) {
  const std::string toggle = only.empty() ? "" : " '--toggle-collect=" + only + "'";
  const std::string all =
      "valgrind --tool=callgrind --callgrind-out-file=/dev/null" + toggle + " " + command + " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(all.c_str(), "r"), pclose);
  if (!pipe) return std::nullopt;
  char line[512];
  while (std::fgets(line, sizeof(line), pipe.get())) {
    double count = 0;
    const char* found = std::strstr(line, "Collected : ");
    if (found && std::sscanf(found, "Collected : %lf", &count) == 1) return count;
  }
  return std::nullopt;
}

// Of one round more; what follows the number of rounds in the command is `rest`.
std::optional<double> PerRound(const std::string& command, const std::string& rest,
                               const std::string& only) {
  constexpr int kRounds = 10;
  const auto one = Instructions(command + " 1" + rest, only);
  const auto many = Instructions(command + " " + std::to_string(1 + kRounds) + rest, only);
  if (!one || !many) return std::nullopt;
  return (*many - *one) / kRounds;
}

void RunScripts(int rounds) {
  Tree tree(SequenceOf(1, "<ActOk" + Attribute("_skipIf", "battery > 20 && !charging") + "/>"));
  const Script& script = tree.executor.program().scripts.at(0);
  Blackboard blackboard = tree.executor.blackboard();
  for (int i = 0; i < rounds * 1000; ++i) script.Test(blackboard);
}

}  // namespace

std::optional<double> InstructionsPerRound(const std::string& program, const std::string& name) {
  return PerRound(program + " --case '" + name + "'", "",
                  IsWorkload(name) ? "coppice::Executor::Tick()" : "");
}

std::optional<double> PeerInstructionsPerRound(const std::string& program,
                                               const Workload& workload) {
  const std::filesystem::path peer =
      std::filesystem::path(program).parent_path() / "coppice_peer_bench";
  if (!std::filesystem::exists(peer) || workload.sinks > 0 || workload.streams) return {};
  const std::string file = "/tmp/coppice_peer_" + std::to_string(getpid()) + ".xml";
  std::ofstream(file) << workload.text;
  const auto instructions = PerRound(peer.string(), " < " + file, "CoppicePeerTick");
  std::filesystem::remove(file);
  if (!instructions || *instructions <= 0) return {};  // a tree that the peer cannot run
  return instructions;
}

int RunCase(const std::string& name, int rounds) {
  if (name == "script") {
    RunScripts(rounds);
    return 0;
  }
  if (const WatchedCase* watched = FindWatchedCase(name)) {
    Run(*watched, rounds);
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
