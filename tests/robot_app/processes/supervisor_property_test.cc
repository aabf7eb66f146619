// Random requests, crashes and kills of the supervisor itself, in simulated time. What must hold at
// every moment is watched by SimulatedMachine (one instance of each program, dependencies ready at
// each start) and here; what must hold when it is quiet again is looked at in the end.
#include <gtest/gtest.h>

#include <random>

#include "tests/robot_app/processes/simulated_machine.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kProcesses = 8;

// A random robot: who depends on whom, which groups and strategies, which configurations.
RobotConfig RandomRobot(std::mt19937& random) {
  const auto chance = [&random](double p) { return std::bernoulli_distribution(p)(random); };
  RobotConfig config;
  for (std::size_t i = 0; i < kProcesses; ++i) {
    ProcessConfig process = MakeProcess("p" + std::to_string(i));
    for (std::size_t earlier = 0; earlier < i; ++earlier) {
      if (chance(0.25)) process.depends.push_back(earlier);
      if (chance(0.1)) process.after.push_back(earlier);
    }
    config.processes.push_back(process);
  }
  // Neighbours share a group, so that groups do not wait for each other in a circle.
  for (std::size_t i = 0; i < kProcesses; ++i) {
    if (i == 0 || chance(0.6)) {
      GroupConfig group;
      group.name = "g" + std::to_string(config.groups.size());
      group.strategy = static_cast<Strategy>(std::uniform_int_distribution<>(0, 2)(random));
      group.essential = chance(0.7);
      config.groups.push_back(group);
    }
    config.processes[i].group = config.groups.size() - 1;
    config.groups.back().processes.push_back(i);
  }
  // Any set that holds what its members depend on; the last one is the safe stop.
  for (int c = 0; c < 4; ++c) {
    Configuration configuration;
    configuration.name = "c" + std::to_string(c);
    for (std::size_t i = 0; i < kProcesses; ++i) {
      const Indices& needs = config.processes[i].depends;
      const bool possible = std::all_of(needs.begin(), needs.end(), [&](std::size_t needed) {
        return Contains(configuration.processes, needed);
      });
      if (possible && chance(c == 3 ? 0.4 : 0.8)) configuration.processes.push_back(i);
    }
    config.configurations.push_back(configuration);
  }
  config.given_up.configuration = 3;
  return config;
}

class SupervisorPropertyTest : public testing::TestWithParam<unsigned> {
 protected:
  std::size_t Any(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  bool Chance(double p) { return std::bernoulli_distribution(p)(random_); }
  std::string AnyProcess() { return config_.processes[Any(kProcesses)].name; }

  void GiveTheProgramsCharacters() {
    for (const ProcessConfig& process : config_.processes) {
      Program& program = robot_.machine.programs[process.name];
      program.loads = milliseconds(Any(4000));
      program.ends = milliseconds(Any(2000));
      program.ignores_term = Chance(0.15);
      if (Chance(0.25)) {
        program.crashes = [this]() -> std::optional<Duration> {
          if (healed_ || Chance(0.4)) return std::nullopt;
          return milliseconds(Any(20000));
        };
      }
    }
  }

  void DoSomething() {
    Supervisor& supervisor = robot_.supervisor();
    const Time now = robot_.machine.now;
    switch (Any(8)) {
      case 0:
      case 1:
        return robot_.machine.Crash(AnyProcess());
      case 2:
        static_cast<void>(supervisor.Restart(AnyProcess(), now));
        return;
      case 3:
        static_cast<void>(supervisor.Restart(config_.groups[Any(config_.groups.size())].name, now));
        return;
      case 4:
      case 5:
        static_cast<void>(supervisor.SetConfiguration("c" + std::to_string(Any(4)),
                                                      Chance(0.3) ? Hand::kPerson : Hand::kTree,
                                                      kNoConditions));
        return;
      case 6:
        if (Chance(0.5)) supervisor.Release();
        if (Chance(0.3)) static_cast<void>(supervisor.Reset("all", now));
        return;
      default:  // once too often would be the end
        if (Chance(0.2) && supervisor.Remember().stack_restarts.empty()) {
          supervisor.OnMasterEnded(now);
        }
    }
  }

  bool IsQuiet() { return !robot_.supervisor().IsChanging(); }

  // What runs is what the configuration says, without what was given up and what needs that.
  void ExpectSettled() {
    const Supervisor& supervisor = robot_.supervisor();
    const GroupOrder order(config_);
    const Indices& wanted =
        config_.configurations[supervisor.configuration_switch().current()].processes;
    for (std::size_t i = 0; i < kProcesses; ++i) {
      const std::string& name = config_.processes[i].name;
      bool given_up = false;
      for (const std::size_t group : order.upstream(config_.processes[i].group)) {
        const std::size_t member = config_.groups[group].processes.front();
        given_up = given_up || supervisor.escalation(member) == EscalationStep::kPerson;
      }
      const bool should_run = Contains(wanted, i) && !given_up;
      EXPECT_EQ(robot_.machine.Runs(name), should_run) << name;
      if (should_run) {
        EXPECT_EQ(supervisor.status(i).phase, ProcessPhase::kReady) << name;
      }
    }
  }

  // Between two looks at the robot no program starts more often than its back-off can allow.
  void ExpectFewStarts(std::size_t begin, Duration duration, int requests) {
    std::map<std::string, int> starts;
    for (std::size_t i = begin; i < robot_.machine.starts.size(); ++i) {
      ++starts[robot_.machine.starts[i].first];
    }
    const int by_time = static_cast<int>(duration / seconds(5)) + 2;
    for (const auto& [name, count] : starts) EXPECT_LE(count, by_time + requests) << name;
  }

  std::mt19937 random_{GetParam()};
  const RobotConfig config_ = RandomRobot(random_);
  SimulatedRobot robot_{config_};
  bool healed_ = false;
};

TEST_P(SupervisorPropertyTest, WhateverHappensItSettlesAsItShould) {
  GiveTheProgramsCharacters();
  for (int i = 0; i < 60; ++i) {
    const std::size_t starts = robot_.machine.starts.size();
    const int changes = static_cast<int>(Any(4));
    for (int k = 0; k < changes; ++k) DoSomething();
    const Duration duration = milliseconds(Any(15000));
    robot_.RunFor(duration);
    ExpectFewStarts(starts, duration, changes + 1);
    if (HasFailure()) return;
  }
  healed_ = true;
  // The longest wait: a back-off, then the slowest chain of starts and ends.
  EXPECT_TRUE(robot_.RunUntil([this] { return IsQuiet(); }, seconds(900)));
  robot_.RunFor(seconds(60));
  EXPECT_TRUE(IsQuiet());
  ExpectSettled();
}

INSTANTIATE_TEST_SUITE_P(Seeds, SupervisorPropertyTest, testing::Range(1u, 301u));

}  // namespace
}  // namespace coppice::robot::processes
