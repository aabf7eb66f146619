// Random subsets of the robot's programs are killed one by one and come back in another order, some
// restarted by hand, the others by the robot itself; each time it must come back to nominal.
//
// COPPICE_SWIZZLES says how many (default 6); `./dev bench swizzle` runs 50.
#include <coppice_msgs/RestartProcess.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <sstream>

#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

constexpr double kBackToNominal = 60;  // s, wall; at most

int Swizzles() {
  const char* text = std::getenv("COPPICE_SWIZZLES");
  return text != nullptr ? std::max(1, std::atoi(text)) : 6;
}

// All that runs, but for what stands for the robot's hardware.
std::vector<std::string> Programs(const RobotState& state) {
  std::vector<std::string> names;
  for (const auto& [name, process] : state.processes()) {
    if (name != "simulator" && state.ReadyPid(name) != 0) names.push_back(name);
  }
  return names;
}

template <class Random>
std::vector<std::string> RandomSubset(std::vector<std::string> names, Random& random) {
  std::shuffle(names.begin(), names.end(), random);
  names.resize(std::uniform_int_distribution<std::size_t>(1, names.size())(random));
  return names;
}

std::string Join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

// By hand, as an impatient operator would, while the robot helps itself. Refusals are part of it.
void BringBack(const std::string& process) {
  coppice_msgs::RestartProcess service;
  service.request.name = process;
  ros::service::call("/supervisor/restart", service);
}

RigOptions Options() {
  RigOptions options;
  options.name = "swizzle";
  options.start = "2 0 0";
  options.variables = {{"speed", "1"}, {"seed", "3"}};
  // Here it is the test that breaks everything again and again, which nobody is to be called for.
  options.edits = {
      {"robot.yaml", "{restarts: 3, window: 60, floor: 5, healthy_after: 60, hourly: 10}",
       "{restarts: 1000, window: 60, floor: 0, healthy_after: 1, hourly: 10000}"},
      {"robot.yaml", "back_off: {first: 5, most: 300}", "back_off: {first: 1, most: 1}"}};
  return options;
}

// Kills them, brings them back, and tells how long it took until all was well; nothing if it was
// not in time.
template <class Random>
std::optional<double> Swizzle(RobotRig& rig, std::vector<std::string> victims, Random& random) {
  std::map<std::string, int> pids;
  const Instant begin = rig.Now();
  for (const std::string& victim : victims) {
    pids[victim] = rig.With([&](const RobotState& state) { return state.Pid(victim); });
    if (pids[victim] != 0) kill(pids[victim], SIGKILL);
    rig.Note("killed " + victim);
    // The pause is a part of the fault.
    rig.WaitFor([](const RobotState&) { return false; },
                std::uniform_real_distribution<double>(0, 0.3)(random));
  }
  std::shuffle(victims.begin(), victims.end(), random);
  for (const std::string& victim : victims) {
    if (std::bernoulli_distribution(0.5)(random)) BringBack(victim);
  }
  const auto back = [&](const RobotState& state) {
    for (const auto& [name, pid] : pids) {
      if (state.ReadyPid(name) == 0 || state.ReadyPid(name) == pid) return false;
    }
    return true;
  };
  EXPECT_TRUE(rig.WaitFor(back, kBackToNominal));
  const std::optional<Instant> nominal = rig.WaitUntilNominal(kBackToNominal, 3);
  if (!nominal) {
    ADD_FAILURE() << rig.TimelineSince(begin);
    return std::nullopt;
  }
  return nominal->wall - begin.wall;
}

TEST(Swizzle, TheRobotComesBackFromAnySubsetOfDeadPrograms) {
  RobotRig rig(Options());
  ASSERT_TRUE(rig.Start());
  std::vector<double> times;
  for (int seed = 1; seed <= Swizzles(); ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    const std::vector<std::string> victims = RandomSubset(rig.With(Programs), random);
    const std::optional<double> seconds = Swizzle(rig, victims, random);
    ASSERT_TRUE(seconds) << "swizzle " << seed << ": " << Join(victims);
    std::cout << "swizzle " << seed << ": " << std::fixed << std::setprecision(1) << *seconds
              << " s after " << Join(victims) << std::endl;
    times.push_back(*seconds);
  }
  std::sort(times.begin(), times.end());
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "median " << times[times.size() / 2] << ", longest "
       << times.back();
  WriteReport({std::to_string(times.size()) + " random swizzles",
               "SIGKILL to a random subset, half of it restarted by hand", "several", "-", "-",
               "restarts", "no", text.str()});
}

}  // namespace
}  // namespace coppice::robot
