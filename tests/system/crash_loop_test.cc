// A program that others depend on crashes 5 to 15 s after every start, whoever restarts it: the
// crash loop that no restart of a node ends. The process supervisor must recognise it, stop
// restarting it alone, and escalate. Real time; the figures are wall time.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <csignal>

#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

using coppice_msgs::ProcessState;

constexpr char kVictim[] = "odometry_filter";
constexpr char kDamage[] = "/crash_loop/coppice_odometry_filter";

RigOptions Options() {
  RigOptions options;
  options.name = "crash_loop";
  options.start = "2 0 0";
  options.variables = {{"speed", "1"}, {"seed", "2"}};
  options.programs = {
      {"coppice-odometry-filter", std::string(COPPICE_BINARY_DIR) + "/tests/bin/crash_loop"}};
  return options;
}

int Escalation(const RobotState& state) {
  const auto found = state.processes().find(kVictim);
  return found == state.processes().end() ? 0 : found->second.escalation;
}

unsigned Restarts(const RobotState& state) {
  const auto found = state.processes().find(kVictim);
  return found == state.processes().end() ? 0 : found->second.restarts;
}

// A ROS master answers, and knows nothing of the damage.
bool IsHealed() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = kDamage;
  return ros::master::execute("hasParam", request, response, payload, false) &&
         !static_cast<bool>(payload);
}

// The damage lies on the ROS parameter server, so only a new ROS master heals it.
TEST(CrashLoop, IsEndedByARestartOfTheWholeStack) {
  RobotRig rig(Options());
  ASSERT_TRUE(rig.Start());
  FaultCase fault(rig, "crash loop of the odometry filter",
                  "it crashes 5 to 15 s after each start, until the ROS master is new");
  const unsigned before = rig.With(Restarts);
  ros::param::set(kDamage, true);
  ASSERT_TRUE(rig.Signal(kVictim, SIGKILL));

  // Recognised by its third restart, and within a minute of the first.
  ASSERT_TRUE(
      rig.WaitFor([](const RobotState& s) { return Escalation(s) >= ProcessState::CLOSURE; }, 240))
      << rig.TimelineSince({});
  EXPECT_LE(rig.With(Restarts), before + 3);
  ASSERT_TRUE(rig.WaitFor([](const RobotState&) { return IsHealed(); }, 300));
  EXPECT_TRUE(fault.ExpectNominal(300));
  fault.ExpectNobodyAsked();
  fault.set_recovery("restart of it, of it and its dependents, of the whole stack");
}

}  // namespace
}  // namespace coppice::robot
