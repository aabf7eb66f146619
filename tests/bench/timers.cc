#include "tests/bench/timers.h"

#include <ctime>
#include <filesystem>
#include <thread>

#include "bt_core/engine/runner.h"
#include "tests/bench/bench_leaves.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

int ThreadsOfThisProgram() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<int>(std::distance(begin(tasks), end(tasks)));
}

double CpuSeconds() {
  timespec used;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

}  // namespace

TimerCost ArmedTimers(int count) {
  constexpr std::chrono::seconds kObserved(1);
  const int before = ThreadsOfThisProgram();
  WallClock clock;
  Executor executor(Load(ArmedTimeouts(count)), clock);
  executor.Tick();
  Runner runner(executor, {Pace::kEvents, kForever});
  std::thread ticking([&runner] { runner.Run(); });
  const double used = CpuSeconds();
  std::this_thread::sleep_for(kObserved);
  const TimerCost cost{ThreadsOfThisProgram() - before - 1,  // without the one that ticks
                       (CpuSeconds() - used) / kObserved.count() * 100};
  runner.Stop();
  ticking.join();
  return cost;
}

}  // namespace coppice::bench
