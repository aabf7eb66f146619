#include "robot_app/ros/duty_feed.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "bt_core/engine/executor.h"
#include "bt_nodes/application/application_leaves.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

// A tree that succeeds outside of the working hours.
class DutyFeedTest : public testing::Test {
 protected:
  DutyFeedTest() {
    auto registry = std::make_shared<Registry>();
    registry->Register<leaves::IsOffDuty>("IsOffDuty");
    Diagnostics diagnostics;
    auto project = Project::FromText(
        R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><IsOffDuty duty_left="{duty_left}"/>)"
        R"(</BehaviorTree></root>)",
        "duty", diagnostics);
    const auto program =
        Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
    executor_.emplace(program, clock_);
  }

  Status TickWithHours(const char* hours) {
    ros::NodeHandle node;
    const DutyFeed feed(node, *knowledge::OpeningHours::Parse(hours),
                        {executor_->Writer<double>("duty_left")});
    return executor_->Tick();
  }

  SimulatedClock clock_;
  std::optional<Executor> executor_;
};

TEST_F(DutyFeedTest, ARobotThatAlwaysWorksIsOnDuty) {
  EXPECT_EQ(TickWithHours("24/7"), Status::kFailure);
}

TEST_F(DutyFeedTest, ARobotThatNeverWorksIsNot) {
  EXPECT_EQ(TickWithHours("Mo-Su off"), Status::kSuccess);
}

TEST(LocalTimeAt, IsWhatClocksOnTheWallShow) {
  const char* const before = std::getenv("TZ");
  const std::string zone = before ? before : "";
  setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1);
  tzset();
  const knowledge::LocalTime time = LocalTimeAt(1614690000);  // 2021-03-02 13:00 UTC
  before ? setenv("TZ", zone.c_str(), 1) : unsetenv("TZ");
  tzset();
  EXPECT_EQ(knowledge::IsoText(time.day), "2021-03-02");
  EXPECT_EQ(knowledge::ClockText(time.time), "14:00");
}

}  // namespace
}  // namespace coppice::robot::adapters
