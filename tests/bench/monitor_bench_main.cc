// A tick of the shipped monitor tree with a large robot's health on the blackboard: 60 nodes, 40
// topics and all other kinds of monitors.
//
//   coppice_monitor_bench              times of a tick, in microseconds
//   coppice_monitor_bench --case NAME ROUNDS     that many ticks, for callgrind:
//     valgrind --tool=callgrind --toggle-collect='coppice::Executor::Tick()' ...
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

using leaves::Health;

constexpr int kTicks = 20000;

Health HealthOf(const std::string& faulty_monitor) {
  Health health;
  const auto add = [&](const std::string& monitor, const std::string& subject) {
    const bool is_faulty = monitor == faulty_monitor && health.HasError(monitor) == false;
    health.entries.push_back({monitor, subject, "/node_of" + subject,
                              is_faulty ? leaves::HealthLevel::kError : leaves::HealthLevel::kOk,
                              "a message of usual length about what was measured: 12.3 Hz"});
  };
  for (int i = 0; i < 60; ++i) add("node", "/some/node_" + std::to_string(i));
  for (int i = 0; i < 40; ++i) add("topic", "/some/topic_" + std::to_string(i));
  for (const char* monitor :
       {"navigation", "localization", "battery", "charging", "docking", "cpu", "memory", "disk",
        "network", "clock", "process", "tf", "emergency_stop", "logger"}) {
    add(monitor, "/host_a");
    add(monitor, "/host_b");
  }
  return health;
}

struct Case {
  const char* name;
  const char* faulty;
  bool new_report;  // in every tick
};
constexpr Case kCases[] = {
    {"well", "", false},
    {"well_new_report", "", true},
    {"navigation", "navigation", true},
    {"last_of_all", "logger", true},
};

class Bench {
 public:
  explicit Bench(const Case& what) : what_(what), health_(HealthOf(what.faulty)) {
    scenario_.Set("charging", false);
    scenario_.Set("docked", false);
    scenario_.Set("configuration", std::string("operating"));
    scenario_.Set("going_home", false);
    scenario_.Set("distance_to_station", 20.0);
    scenario_.Set("pose", leaves::Pose2D{1, 2, 3});
  }
  // Microseconds of one tick.
  double Tick() {
    scenario_.Advance(0.1);
    if (what_.new_report || first_) {
      scenario_.Set("battery",
                    leaves::BatteryReading{scenario_.now(), 25, -6, 0.8, leaves::kNotMeasured, {}});
    }
    if (what_.new_report || first_ || scenario_.now() - health_.stamp > std::chrono::seconds(5)) {
      health_.stamp = scenario_.now();
      scenario_.Set("monitoring", health_);
    }
    first_ = false;
    const auto begin = std::chrono::steady_clock::now();
    scenario_.Tick();
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
    return took.count();
  }

 private:
  const Case& what_;
  Health health_;
  TreeScenario scenario_{"monitor/monitor.xml"};
  bool first_ = true;
};

void PrintTimes() {
  std::printf("%-18s %10s %10s %10s\n", "one tick [us]", "median", "99 %", "most");
  for (const Case& one : kCases) {
    Bench bench(one);
    std::vector<double> times(kTicks);
    for (double& time : times) time = bench.Tick();
    std::sort(times.begin(), times.end());
    std::printf("%-18s %10.2f %10.2f %10.2f\n", one.name, times[kTicks / 2],
                times[kTicks * 99 / 100], times.back());
  }
}

int Main(int argc, char** argv) {
  if (argc == 1) {
    PrintTimes();
    return 0;
  }
  for (const Case& one : kCases) {
    if (argc != 4 || std::strcmp(argv[1], "--case") != 0) break;
    if (std::strcmp(argv[2], one.name) != 0) continue;
    Bench bench(one);
    for (int i = std::atoi(argv[3]); i > 0; --i) bench.Tick();
    return 0;
  }
  std::fprintf(stderr, "coppice_monitor_bench [--case NAME ROUNDS]\n");
  return 2;
}

}  // namespace
}  // namespace coppice

int main(int argc, char** argv) { return coppice::Main(argc, argv); }
