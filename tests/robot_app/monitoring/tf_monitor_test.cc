#include "robot_app/monitoring/tf_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

TransformWatch Watch() {
  TransformWatch watch{"map", "base_link", "/localization", {}, {}, 0};
  watch.age = {{std::nullopt, 0.5}, {std::nullopt, 1}, 1, seconds(3), 0};
  watch.jump = {{std::nullopt, 0.5}, {std::nullopt, 2}, 1, Duration::zero(), 0};
  return watch;
}

class TfMonitorTest : public testing::Test {
 protected:
  TfMonitorTest() { monitor_.Watch({Watch()}); }
  void Look(Time stamp, Time now, double x = 0, const std::string& parent = "odom") {
    monitor_.OnSamples({TransformSample{stamp, x, 0, 0, parent}}, {now, now});
  }
  void LookInVain(Time now) { monitor_.OnSamples({Problem{"no such frame"}}, {now, now}); }
  Finding About(const std::string& what, Time now) {
    for (const Finding& finding : monitor_.Report(processes_, {now, now})) {
      EXPECT_EQ(finding.monitor, "tf");
      if (finding.subject == "map -> base_link " + what) return finding;
    }
    ADD_FAILURE() << "nothing about " << what;
    return {};
  }
  TfMonitor monitor_;
  ProcessTable processes_;
};

TEST_F(TfMonitorTest, SaysWhereToLook) {
  ASSERT_EQ(monitor_.Pairs().size(), 1u);
  EXPECT_EQ(monitor_.Pairs()[0].first, "map");
  EXPECT_EQ(monitor_.Pairs()[0].second, "base_link");
}

TEST_F(TfMonitorTest, AFreshTransformIsWellAndAnOldOneAnError) {
  Look(Time(seconds(10)), Time(seconds(10) + milliseconds(100)));
  EXPECT_EQ(About("age", Time(seconds(10))).level, HealthLevel::kOk);
  EXPECT_NEAR(About("age", Time(seconds(10))).value, 0.1, 1e-9);
  Look(Time(seconds(10)), Time(seconds(12)));
  EXPECT_EQ(About("age", Time(seconds(12))).level, HealthLevel::kError);
  EXPECT_EQ(About("age", Time(seconds(12))).node, "/localization");
  EXPECT_EQ(About("age", Time(seconds(12))).message, "2 s, expected at most 1 s");
}

TEST_F(TfMonitorTest, ATransformThatIsNotRenewedAgesInTheSlowerOfBothTimes) {
  const auto age = [&](Time stamp, Time ros, Time wall) {
    monitor_.OnSamples({TransformSample{stamp, 0, 0, 0, "odom"}}, {ros, wall});
    return monitor_.Report(processes_, {ros, wall}).at(0).value;
  };
  const Time start{seconds(100)};
  EXPECT_NEAR(age(start, start + milliseconds(200), Time(seconds(1))), 0.2, 1e-9);
  EXPECT_NEAR(age(start, start + seconds(8), Time(seconds(2))), 1.2, 1e-9);  // time runs fast
  EXPECT_NEAR(age(start, start + seconds(9), Time(seconds(99))), 9, 1e-9);
  EXPECT_NEAR(age(start + seconds(7), start + seconds(9), Time(seconds(99))), 2,
              1e-9);  // always late
}

TEST_F(TfMonitorTest, AStaticTransformIsNeverOld) {
  Look(Time{}, Time(seconds(1000)));
  EXPECT_EQ(About("age", Time(seconds(1000))).value, 0);
}

TEST_F(TfMonitorTest, ALookupThatFailsIsAnErrorAfterTheStaleness) {
  LookInVain(Time(seconds(1)));
  EXPECT_EQ(About("age", Time(seconds(1))).level, HealthLevel::kOk);
  LookInVain(Time(seconds(5)));
  EXPECT_EQ(About("age", Time(seconds(5))).level, HealthLevel::kError);
  EXPECT_EQ(About("age", Time(seconds(5))).message, "no value for 4 s: no such frame");
}

TEST_F(TfMonitorTest, AJumpIsTheWayBetweenTwoLooks) {
  Look(Time(seconds(1)), Time(seconds(1)), 5);
  EXPECT_TRUE(std::isnan(About("jump", Time(seconds(1))).value));
  Look(Time(seconds(2)), Time(seconds(2)), 5.1);
  EXPECT_EQ(About("jump", Time(seconds(2))).level, HealthLevel::kOk);
  Look(Time(seconds(3)), Time(seconds(3)), 9);
  EXPECT_EQ(About("jump", Time(seconds(3))).level, HealthLevel::kError);
  EXPECT_NEAR(About("jump", Time(seconds(3))).value, 3.9, 1e-9);
  Look(Time(seconds(4)), Time(seconds(4)), 9);
  EXPECT_EQ(About("jump", Time(seconds(4))).level, HealthLevel::kOk);
}

TEST_F(TfMonitorTest, WhatTheChildCanHaveDrivenIsNoJump) {
  TransformWatch watch = Watch();
  watch.speed = 1;
  monitor_.Watch({watch});
  Look(Time(seconds(10)), Time(seconds(10)), 0);
  Look(Time(seconds(13)), Time(seconds(13)), 2.9);
  EXPECT_EQ(About("jump", Time(seconds(13))).value, 0);
  Look(Time(seconds(14)), Time(seconds(14)), 4.5);
  EXPECT_EQ(About("jump", Time(seconds(14))).level, HealthLevel::kWarn);
  EXPECT_NEAR(About("jump", Time(seconds(14))).value, 0.6, 1e-9);
}

TEST_F(TfMonitorTest, TimeThatIsSetBackIsNoJump) {
  Look(Time(seconds(10)), Time(seconds(10)), 5);
  Look(Time(seconds(1)), Time(seconds(1)), 0);
  EXPECT_TRUE(std::isnan(About("jump", Time(seconds(1))).value));
  Look(Time(seconds(2)), Time(seconds(2)), 3);
  EXPECT_NEAR(About("jump", Time(seconds(2))).value, 3, 1e-9);
}

TEST_F(TfMonitorTest, AChildThatChangesItsParentIsAnError) {
  Look(Time(seconds(1)), Time(seconds(1)), 0, "odom");
  EXPECT_EQ(About("parent", Time(seconds(1))).level, HealthLevel::kOk);
  Look(Time(seconds(2)), Time(seconds(2)), 0, "odom_of_the_wheels");
  EXPECT_EQ(About("parent", Time(seconds(2))).level, HealthLevel::kError);
  EXPECT_EQ(About("parent", Time(seconds(2))).message,
            "base_link hung on odom, now on odom_of_the_wheels");
  Look(Time(seconds(3)), Time(seconds(3)), 0, "odom");
  EXPECT_EQ(About("parent", Time(seconds(3))).level, HealthLevel::kOk);
}

TEST_F(TfMonitorTest, AnOwnerThatStartsHasItsTime) {
  Look(Time(seconds(1)), Time(seconds(1)), 0);
  processes_.by_node["/localization"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(About("age", Time(seconds(20))).level, HealthLevel::kOk);
  processes_.by_node["/localization"].phase = ProcessPhase::kReady;
  Look(Time(seconds(21)), Time(seconds(21)), 50);  // found itself elsewhere
  EXPECT_TRUE(std::isnan(About("jump", Time(seconds(21))).value));
}

TEST_F(TfMonitorTest, AChangeOfTheListKeepsWhatWasSeen) {
  Look(Time(seconds(1)), Time(seconds(1)), 0, "odom");
  TransformWatch other = Watch();
  other.child = "laser";
  monitor_.Watch({other, Watch()});
  EXPECT_EQ(About("age", Time(seconds(1))).value, 0);
}

}  // namespace
}  // namespace coppice::robot::monitoring
