// A visitor is greeted and led to a place, with the real leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

using leaves::PeopleView;
using leaves::Pose2D;
using leaves::SeenPerson;
using leaves::Visitor;
using testing::Contains;
using testing::ElementsAre;

class Guiding : public testing::Test {
 protected:
  void Ask(int request, const std::string& place = "office") {
    visitor_.request = request;
    visitor_.place = place;
    visitor_.asked = scenario_.now();
    scenario_.Set("visitor", visitor_);
  }
  void Somebody(double x, double y, std::uint32_t id = 7) {
    people_ = {{id, x, y, 0, 10, 0, leaves::Mask::kUnknown}};
  }
  // Perception goes on; the robot does what it is told, and speaks.
  Status Live(double seconds) {
    Status status = Status::kRunning;
    for (double time = 0; time < seconds && status == Status::kRunning; time += 0.5) {
      scenario_.Set("people", PeopleView{scenario_.now(), people_});
      if (scenario_.CallsBeginning("Say") > spoken_) {
        ++spoken_;
        scenario_.robot.done.Send({true, ""});
      }
      status = scenario_.Tick();
      scenario_.Advance(0.5);
    }
    return status;
  }
  void SetUp() override {
    scenario_.Set("pose", Pose2D{0, 0, 0});
    scenario_.Set("docked", false);
    scenario_.robot.legs = {{"a -> office", "drive", {1, 0, 0}, "office"}};
  }

  TreeScenario scenario_{"behavior/guide.xml"};
  Visitor visitor_;
  std::vector<SeenPerson> people_;
  long spoken_ = 0;  // phrases to their end
};

TEST_F(Guiding, LeadsWhoAskedToThePlaceAndTakesLeave) {
  Ask(3);
  Somebody(1, 0);  // before the robot: who asked
  Live(2);
  Somebody(-1.5, 0);  // behind it
  Live(2);
  EXPECT_THAT(scenario_.robot.calls, Contains("NavigateTo 1;0;0"));
  scenario_.Answer(true);
  EXPECT_EQ(Live(5), Status::kSuccess);
  EXPECT_THAT(scenario_.robot.calls, Contains("Say LEAD_ON en office in en"));
  EXPECT_THAT(scenario_.robot.calls, Contains("Say ARRIVED en office in en"));
  EXPECT_THAT(scenario_.robot.calls, Contains("Release GUIDING"));
  EXPECT_EQ(scenario_.LastCall(), "Settle 3 arrived");
}

TEST_F(Guiding, DrivesSlowlyWhenTheVisitorFallsBehind) {
  Ask(3);
  Somebody(-1, 0);
  Live(3);
  EXPECT_THAT(scenario_.robot.calls, Contains("LimitSpeed 0.5"));
  EXPECT_EQ(scenario_.CallsOf("LimitSpeed 0.25"), 0);
  Somebody(-3, 0);
  Live(1);
  EXPECT_THAT(scenario_.robot.calls, Contains("LimitSpeed 0.25"));
}

TEST_F(Guiding, WaitsForAVisitorWhoHasStayedBehindAndDrivesOnWhenHeIsBack) {
  Ask(3);
  Somebody(-1, 0);
  Live(3);
  Somebody(-6, 0);
  Live(4);
  EXPECT_THAT(scenario_.robot.calls, Contains("CancelNavigation"));
  EXPECT_THAT(scenario_.robot.calls, Contains("Say ARE_YOU_THERE en"));
  Somebody(-1, 0);
  Live(3);
  EXPECT_EQ(scenario_.CallsOf("NavigateTo 1;0;0"), 2);
}

TEST_F(Guiding, GivesUpWhenTheVisitorDoesNotComeBack) {
  Ask(3);
  Somebody(-1, 0);
  Live(3);
  people_.clear();
  EXPECT_EQ(Live(20), Status::kSuccess);
  EXPECT_THAT(scenario_.robot.calls, Contains("Say LOST_YOU en"));
  EXPECT_EQ(scenario_.LastCall(), "Settle 3 lost");
}

TEST_F(Guiding, StopsWhenTheVisitorTakesItBack) {
  Ask(3);
  Somebody(-1, 0);
  Live(3);
  Ask(0);
  EXPECT_EQ(Live(2), Status::kSuccess);
  EXPECT_THAT(scenario_.robot.calls, Contains("CancelNavigation"));
  EXPECT_EQ(scenario_.CallsBeginning("Say LOST"), 0);
}

TEST_F(Guiding, FailsAtOnceWhereNobodyWantsAnything) {
  EXPECT_EQ(scenario_.Tick(), Status::kFailure);
  EXPECT_THAT(scenario_.robot.calls, testing::IsEmpty());
}

TEST_F(Guiding, SaysThatItDoesNotGetToAPlaceThatThereIsNot) {
  Ask(3, "nowhere");
  Somebody(1, 0);
  EXPECT_EQ(Live(5), Status::kSuccess);
  EXPECT_THAT(scenario_.robot.calls,
              ElementsAre("Hold GUIDING", "Say NO_WAY en", "Release GUIDING", "Settle 3 blocked"));
}

TEST(Greeting, EachVisitorOnceWithAFriendlyFace) {
  TreeScenario scenario("behavior/greet.xml");
  const auto see = [&](std::uint32_t id) {
    scenario.Set("people",
                 PeopleView{scenario.now(), {{id, 1, 0, 0, 10, 0, leaves::Mask::kUnknown}}});
  };
  scenario.Set("language", std::string("en"));
  see(7);
  scenario.Tick();
  scenario.Tick();
  EXPECT_THAT(scenario.robot.calls, ElementsAre("Hold GREETING", "Say GREETING en"));
  scenario.Answer(true);
  scenario.Advance(4);
  see(7);
  EXPECT_EQ(scenario.Tick(), Status::kSuccess);
  EXPECT_EQ(scenario.LastCall(), "Release GREETING");
  EXPECT_EQ(scenario.Tick(), Status::kFailure) << "he has been greeted";
  see(8);
  EXPECT_EQ(scenario.Tick(), Status::kRunning);
}

}  // namespace
}  // namespace coppice
