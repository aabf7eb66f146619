// Benchmarks of the engine. `coppice_bench` takes the options of Google Benchmark; `coppice_bench
// --counts` prints instructions and bytes instead of times.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <cstring>

#include "tests/bench/bench_leaves.h"
#include "tests/bench/counts.h"
#include "tests/bench/instructions.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

void TickLoop(benchmark::State& state, const std::string& text, double per, int sinks = 0) {
  Tree tree(text, sinks);
  for (auto _ : state) benchmark::DoNotOptimize(tree.executor.Tick());
  state.counters["per"] = benchmark::Counter(
      per, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void FullTraversal(benchmark::State& state) {
  const auto arity = static_cast<int>(state.range(0));
  const auto nodes = static_cast<int>(state.range(1));
  TickLoop(state, FullTree(arity, nodes), nodes);
}
BENCHMARK(FullTraversal)->ArgsProduct({{4, 2}, {10, 100, 1000, 10000, 50000, 100000}});

void FullTraversalWithSinks(benchmark::State& state) {
  TickLoop(state, FullTree(4, 1000), 1000, static_cast<int>(state.range(0)));
}
BENCHMARK(FullTraversalWithSinks)->Arg(0)->Arg(1)->Arg(5);

void ArbiterFlat(benchmark::State& state) { TickLoop(state, FlatArbiter(), 52); }
BENCHMARK(ArbiterFlat);

void ArbiterGuarded(benchmark::State& state) { TickLoop(state, GuardedArbiter(), 102); }
BENCHMARK(ArbiterGuarded);

void ArbiterWithPorts(benchmark::State& state) { TickLoop(state, PortArbiter(), 52); }
BENCHMARK(ArbiterWithPorts);

void ArbiterWithScripts(benchmark::State& state) { TickLoop(state, ScriptArbiter(), 52); }
BENCHMARK(ArbiterWithScripts);

void GuardedNodes(benchmark::State& state) {
  const std::string guard = Attribute("_skipIf", "battery > 20 && !charging");
  TickLoop(state, SequenceOf(100, "<ActOk" + guard + "/>"), 100);
}
BENCHMARK(GuardedNodes);

void PortRead(benchmark::State& state) { TickLoop(state, ReadLoop(1000), 1000); }
BENCHMARK(PortRead);

void PortWrite(benchmark::State& state) { TickLoop(state, WriteLoop(1000), 1000); }
BENCHMARK(PortWrite);

// From text to a tree that can tick.
void LoadText(benchmark::State& state) {
  const auto nodes = static_cast<int>(state.range(1));
  const std::string text = FullTree(static_cast<int>(state.range(0)), nodes);
  for (auto _ : state) {
    SimulatedClock clock;
    const Executor executor(Load(text), clock);
    benchmark::DoNotOptimize(executor.statuses().data());
  }
  state.counters["per"] = benchmark::Counter(
      nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(LoadText)->ArgsProduct({{4, 2}, {1000, 10000, 100000}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coppice::bench

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--counts") == 0) {
    return coppice::bench::PrintCounts(argv[0]);
  }
  if (argc == 4 && std::strcmp(argv[1], "--case") == 0) {
    return coppice::bench::RunCase(argv[2], std::atoi(argv[3]));
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
