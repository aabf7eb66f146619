#include "bt_nodes/navigation/route_leaves.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

template <class Leaf>
LeafHarness AtPlace(FakeRobot& robot, const std::string& place) {
  LeafHarness harness = LeafHarness::For<Leaf>(std::ref<Routes>(robot));
  harness.Set("place", place);
  harness.Set("pose", Pose2D{1, 2, 0});
  return harness;
}

TEST(NextLeg, GivesTheLegAndWhoTravelsIt) {
  FakeRobot robot;
  robot.legs = {{"hall -> office", "door", {3, 4, 1}, "the office"}};
  LeafHarness harness = AtPlace<NextLeg>(robot, "office");
  harness.Set("language", std::string("de"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<std::string>("leg"), "hall -> office");
  EXPECT_EQ(harness.Get<std::string>("kind"), "door");
  EXPECT_EQ(harness.Get<Pose2D>("goal").y, 4);
  EXPECT_EQ(harness.Get<std::string>("spoken"), "the office");
  EXPECT_EQ(robot.languages, std::vector<std::string>{"de"});
}

TEST(NextLeg, FailsWhereTheRobotIsThereAndWhereThereIsNoWay) {
  FakeRobot robot;
  LeafHarness there = AtPlace<NextLeg>(robot, "office");
  EXPECT_EQ(there.Tick(), Status::kFailure);
  EXPECT_EQ(there.message(), "the robot is there");
  LeafHarness nowhere = AtPlace<NextLeg>(robot, "nowhere");
  EXPECT_EQ(nowhere.Tick(), Status::kFailure);
  EXPECT_EQ(nowhere.message(), R"(there is no place "nowhere")");
}

TEST(RememberLeg, TellsHowTheLegEnded) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<RememberLeg>(std::ref<Routes>(robot));
  harness.Set("leg", std::string("hall -> office"));
  harness.Set("pose", Pose2D{1, 2, 0});
  harness.Set("travelled", false);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"blocked hall -> office"});
}

TEST(IsAtPlace, IsTrueWhenNoLegIsLeftOfAPlaceThatThereIs) {
  FakeRobot robot;
  EXPECT_EQ(AtPlace<IsAtPlace>(robot, "office").Tick(), Status::kSuccess);
  EXPECT_EQ(AtPlace<IsAtPlace>(robot, "nowhere").Tick(), Status::kFailure);
  robot.legs = {{"hall -> office", "door", {}, ""}};
  EXPECT_EQ(AtPlace<IsAtPlace>(robot, "office").Tick(), Status::kFailure);
}

TEST(NearestPlace, NamesThePlaceOrSaysWhyThereIsNone) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<NearestPlace>(std::ref<Routes>(robot));
  harness.Set("pose", Pose2D{1, 2, 0});
  harness.Set("category", std::string("office"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<std::string>("place"), "office_103");
  harness.Set("category", std::string("pool"));
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "there is no pool");
}

TEST(DescribePlace, GivesWhatIsSaidInTheLanguage) {
  FakeRobot robot;
  LeafHarness harness = AtPlace<DescribePlace>(robot, "upstairs");
  harness.Set("language", std::string("de"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<std::string>("spoken"), "upstairs in de");
  EXPECT_EQ(harness.Get<std::string>("words"), "Take the stairs.");
}

TEST(WayIsFree, AsksWithoutMovingAndWaitsForTheAnswer) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<WayIsFree>(std::ref<Navigator>(robot));
  harness.Set("goal", Pose2D{1, 2, 0});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"FindWay 1;2;0"});
  robot.done.Send({false, "no way"});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "no way");
}

}  // namespace
}  // namespace coppice::leaves
