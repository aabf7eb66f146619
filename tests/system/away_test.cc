// The robot is brought to a site without a station: it works there on that site's map until the
// battery's reserve, drives to the meeting point, asks to be picked up, and switches itself off. At
// four times real time.
#include <coppice_msgs/AnswerHelp.h>
#include <coppice_msgs/SetSite.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>

#include <cmath>
#include <filesystem>

#include "tests/robot_app/eventually.h"
#include "tests/system/robot_rig.h"

namespace coppice::robot {
namespace {

constexpr double kPatience = 120;  // s, wall
constexpr double kLift[] = {1.6, 0};

RigOptions Options() {
  RigOptions options;
  options.name = "away";
  options.variables = {{"speed", "4"}, {"seed", "3"}};
  options.environment = {{"COPPICE_SWITCH_OFF_TOKEN", "for the test"}};
  return options;
}

bool Bring(const std::string& site) {
  coppice_msgs::SetSite service;
  service.request.site = site;
  service.request.manual = true;
  if (!ros::service::call("/supervisor/set_site", service)) return false;
  EXPECT_TRUE(service.response.ok) << service.response.message;
  return service.response.ok;
}

bool Answer() {
  coppice_msgs::AnswerHelp service;
  service.request.by = "the test";
  service.request.fixed = true;
  return ros::service::call("/assistance/answer", service) && service.response.ok;
}

double FromLift(const RobotState& state) {
  return std::hypot(state.truth().x - kLift[0], state.truth().y - kLift[1]);
}

TEST(Away, WorksUntilTheReserveThenAsksAtTheMeetingPointToBePickedUpAndSwitchesItselfOff) {
  RobotRig rig(Options());
  ASSERT_TRUE(rig.Start());
  ASSERT_TRUE(Bring("institute_upper"));
  const auto is_away = [](const RobotState& state) { return state.configuration() == "away"; };
  ASSERT_TRUE(rig.WaitFor(is_away, kPatience));
  ASSERT_TRUE(rig.WaitUntilNominal(kPatience).has_value());
  EXPECT_EQ(rig.With([](const RobotState& state) { return state.Pid("docking"); }), 0);

  // It works there, and knows where it is.
  ASSERT_TRUE(rig.WaitFor([](const RobotState& state) { return FromLift(state) > 6; }, kPatience))
      << rig.TimelineSince({});
  EXPECT_LT(rig.With([](const RobotState& state) { return state.deviation(); }), 0.3);
  EXPECT_FALSE(rig.With([](const RobotState& state) { return state.IsAsked("pick up"); }));

  ASSERT_TRUE(rig.Inject("set_battery", "", 0.12));
  ASSERT_TRUE(
      rig.WaitFor([](const RobotState& state) { return state.IsAsked("pick up"); }, kPatience))
      << rig.TimelineSince({});
  EXPECT_LT(rig.With(FromLift), 1);
  ASSERT_TRUE(Answer());
  EXPECT_TRUE(Eventually([&] { return std::filesystem::exists(rig.folder() / "switched_off"); }))
      << rig.Logged("supervisor");
}

}  // namespace
}  // namespace coppice::robot
