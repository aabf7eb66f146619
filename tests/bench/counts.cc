#include "tests/bench/counts.h"

#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "tests/bench/bench_leaves.h"
#include "tests/bench/memory.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

struct Case {
  std::string name;
  double per;  // nodes or accesses in one round
  std::string text;
  bool load = false;  // measure loading instead of ticking
};

const std::vector<Case>& Cases() {
  static const std::vector<Case> cases = {
      {"full_4ary_100", 100, FullTree(4, 100)},
      {"full_4ary_1000", 1000, FullTree(4, 1000)},
      {"full_4ary_10000", 10000, FullTree(4, 10000)},
      {"full_2ary_1000", 1000, FullTree(2, 1000)},
      {"arbiter_flat_50", 52, FlatArbiter()},
      {"arbiter_guarded_50", 102, GuardedArbiter()},
      {"arbiter_port_50", 52, PortArbiter()},
      {"port_read", 1000, ReadLoop(1000)},
      {"port_write", 1000, WriteLoop(1000)},
      {"load_4ary_10000", 10000, FullTree(4, 10000), true},
  };
  return cases;
}

// Instructions of one run under callgrind, or nothing.
std::optional<double> Instructions(const std::string& program, const std::string& name,
                                   int rounds) {
  const std::string command = "valgrind --tool=callgrind --callgrind-out-file=/dev/null " +
                              program + " --case " + name + " " + std::to_string(rounds) + " 2>&1";
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

void PrintMemory(int nodes) {
  const std::string text = FullTree(4, nodes);
  BenchRegistry();
  const std::size_t empty = BytesInUse();
  const std::shared_ptr<const Program> program = Load(text);
  const std::size_t loaded = BytesInUse();
  SimulatedClock clock;
  const Executor executor(program, clock);
  const std::size_t running = BytesInUse();
  const auto per_node = [nodes](std::size_t bytes) { return static_cast<double>(bytes) / nodes; };
  std::printf(
      "memory, 4-ary %d: %.1f bytes/node for text, document and program (text alone %.1f), "
      "%.1f for an executor\n",
      nodes, per_node(loaded - empty), per_node(text.size()), per_node(running - loaded));
}

}  // namespace

int RunCase(const std::string& name, int rounds) {
  for (const Case& known : Cases()) {
    if (known.name != name) continue;
    Tree tree(known.text);
    for (int i = 0; i < rounds; ++i) {
      if (known.load) {
        Load(known.text);
      } else {
        tree.executor.Tick();
      }
    }
    return 0;
  }
  std::cerr << "no case " << name << "\n";
  return 2;
}

int PrintCounts(const std::string& program) {
  for (const Case& known : Cases()) {
    const int rounds = known.load ? 2 : 10;
    const auto one = Instructions(program, known.name, 1);
    const auto many = Instructions(program, known.name, 1 + rounds);
    if (!one || !many) {
      std::cerr << "callgrind gave no count; is valgrind installed?\n";
      return 1;
    }
    std::printf("%-20s %8.1f instructions per node or access\n", known.name.c_str(),
                (*many - *one) / rounds / known.per);
    std::fflush(stdout);
  }
  for (const int nodes : {1000, 100000}) PrintMemory(nodes);
  return 0;
}

}  // namespace coppice::bench
