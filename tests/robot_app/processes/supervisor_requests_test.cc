// What may be asked of the supervisor (supervisor_requests.cc).
#include <gmock/gmock.h>

#include "tests/robot_app/processes/simulated_machine.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

// base <- nav <- app; mapper. In "safe" only base runs.
RobotConfig Robot() {
  RobotConfig config;
  config.processes = {MakeProcess("base"), MakeProcess("nav", {0}), MakeProcess("app", {1}),
                      MakeProcess("mapper")};
  AddOwnGroups(config);
  config.conditions.resize(1);
  config.conditions[0].name = "charging_confirmed";
  config.configurations = {{"operating", {0, 1, 2}, {}},
                           {"safe", {0}, {}},
                           {"charging", {0}, {0}},
                           {"mapping", {0, 3}, {}}};
  config.given_up.configuration = 1;
  config.sites = {{"home", 0}, {"hill", 3}};
  return config;
}

class SupervisorRequestsTest : public testing::Test {
 protected:
  SupervisorRequestsTest() {
    EXPECT_TRUE(robot_.RunUntil([this] { return robot_.AllReady(); }, seconds(30)));
    robot_.RunFor(seconds(100));
  }
  Expected<std::string> Restart(const std::string& name) {
    return robot_.supervisor().Restart(name, robot_.machine.now);
  }
  Expected<std::string> Reset(const std::string& name) {
    return robot_.supervisor().Reset(name, robot_.machine.now);
  }
  Expected<std::string> Configure(const std::string& name, Hand hand = Hand::kTree) {
    return robot_.supervisor().SetConfiguration(name, hand, kNoConditions);
  }
  Expected<std::string> Move(const std::string& site, Hand hand = Hand::kPerson) {
    return robot_.supervisor().SetSite(site, hand, [](const std::string&) { return Outcome(); });
  }
  void GiveUpNav() {
    robot_.machine.programs["nav"].crashes = [] { return std::optional<Duration>(seconds(2)); };
    robot_.machine.Crash("nav");
    ASSERT_TRUE(robot_.RunUntil([this] { return !robot_.calls.empty(); }, seconds(600)));
    robot_.RunFor(seconds(10));
    robot_.machine.programs["nav"] = {};
  }

  SimulatedRobot robot_{Robot()};
};

TEST_F(SupervisorRequestsTest, RestartsALivingProcessByTheNameOfItsNode) {
  EXPECT_EQ(Restart("/nav_node").value(), "/nav_node is restarted");
  robot_.RunFor(milliseconds(100));
  EXPECT_EQ(robot_.Phase("nav"), ProcessPhase::kStarting);  // grace begins with the request
  EXPECT_EQ(Restart("nav").value(), "nav is about to start already");
  robot_.RunFor(seconds(10));
  EXPECT_EQ(robot_.Phase("nav"), ProcessPhase::kReady);
  EXPECT_EQ(robot_.machine.Starts("nav"), 2);
  EXPECT_EQ(robot_.machine.Starts("app"), 1);  // what depends on it stays up
}

TEST_F(SupervisorRequestsTest, RestartsOnRequestCountLikeCrashes) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(Restart("nav").value(), "nav is restarted");
    robot_.RunFor(seconds(1));
    ASSERT_TRUE(robot_.RunUntil([this] { return robot_.AllReady(); }, seconds(30)));
  }
  const Expected<std::string> verdict = Restart("nav");
  EXPECT_TRUE(verdict);
  EXPECT_EQ(verdict.value(), "nav is restarted with all that depends on nav");
  robot_.RunFor(seconds(20));
  EXPECT_TRUE(robot_.AllReady());
  EXPECT_EQ(robot_.machine.Starts("app"), 2);
}

TEST_F(SupervisorRequestsTest, RestartsThatDoNotHelpAreRefusedAtLastAndNothingIsTakenDown) {
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(Restart("nav"));
    robot_.RunFor(seconds(20));
  }
  const Expected<std::string> verdict = Restart("nav");
  EXPECT_FALSE(verdict);
  EXPECT_THAT(verdict.problem(), HasSubstr("nav needs a person: restarts have not helped"));
  robot_.RunFor(seconds(20));
  EXPECT_EQ(robot_.Phase("nav"), ProcessPhase::kReady);
  EXPECT_EQ(robot_.machine.Starts("nav"), 5);
  EXPECT_EQ(robot_.stacks, 0);
  robot_.RunFor(seconds(60));
  EXPECT_EQ(Restart("nav").value(), "nav is restarted");  // healthy since
}

TEST_F(SupervisorRequestsTest, ThePersonMayRestartTheWholeStack) {
  EXPECT_TRUE(Restart("all"));
  EXPECT_EQ(Restart("nav").value(), "the whole stack is being restarted");
  EXPECT_TRUE(robot_.RunUntil([this] { return robot_.stacks == 1; }, seconds(30)));
  EXPECT_TRUE(robot_.RunUntil([this] { return robot_.AllReady(); }, seconds(30)));
  EXPECT_EQ(robot_.machine.Starts("base"), 2);
}

TEST_F(SupervisorRequestsTest, RefusesUnknownAndUnwantedNames) {
  EXPECT_THAT(Restart("navv").problem(), HasSubstr(R"(did you mean "nav"?)"));
  EXPECT_THAT(Reset("navv").problem(), HasSubstr(R"(did you mean "nav"?)"));
  EXPECT_EQ(Restart("mapper").problem(), "mapper is not part of configuration operating");
  EXPECT_THAT(Configure("opperating").problem(), HasSubstr(R"(did you mean "operating"?)"));
}

TEST_F(SupervisorRequestsTest, RefusesARestartOfWhatIsGivenUpUntilItIsReset) {
  GiveUpNav();
  EXPECT_EQ(robot_.Phase("nav"), ProcessPhase::kGivenUp);
  EXPECT_EQ(Restart("nav").problem(), "nav is not part of configuration safe");
  EXPECT_THAT(Configure("operating", Hand::kPerson).problem(), HasSubstr("safe stop"));
  robot_.RunFor(seconds(4000));
  EXPECT_FALSE(robot_.machine.Runs("nav"));  // time alone does not repair it
  EXPECT_TRUE(Reset("/nav_node"));
  EXPECT_TRUE(robot_.RunUntil([this] { return robot_.AllReady(); }, seconds(30)));
  EXPECT_EQ(robot_.supervisor().configuration(), "operating");
  EXPECT_EQ(Restart("nav").value(), "nav is restarted");
}

TEST_F(SupervisorRequestsTest, ResetAllForgetsEverything) {
  GiveUpNav();
  EXPECT_TRUE(Reset("all"));
  EXPECT_TRUE(robot_.RunUntil([this] { return robot_.AllReady(); }, seconds(30)));
  EXPECT_EQ(robot_.supervisor().RestartsUsed(robot_.Index("nav"), robot_.machine.now), 0);
}

TEST_F(SupervisorRequestsTest, WhatAPersonSetsIsHeldUntilItIsReleased) {
  EXPECT_TRUE(Configure("mapping", Hand::kPerson));
  EXPECT_EQ(Configure("operating").problem(),
            "configuration mapping is held by hand until it is released");
  EXPECT_TRUE(Configure("mapping"));  // no conflict
  robot_.RunFor(seconds(10));
  EXPECT_TRUE(robot_.machine.Runs("mapper"));
  EXPECT_FALSE(robot_.machine.Runs("nav"));
  robot_.supervisor().Release();
  EXPECT_TRUE(Configure("operating"));
}

TEST_F(SupervisorRequestsTest, AConfigurationIsRefusedWhileItsConditionDoesNotHold) {
  const auto check = [](std::size_t) { return Problem{"no current flows"}; };
  const Expected<std::string> verdict =
      robot_.supervisor().SetConfiguration("charging", Hand::kPerson, check);
  EXPECT_FALSE(verdict);
  EXPECT_EQ(verdict.problem(),
            "configuration charging requires charging_confirmed: no current flows");
  EXPECT_FALSE(robot_.supervisor().configuration_switch().manual());
  EXPECT_TRUE(Configure("charging"));
}

TEST_F(SupervisorRequestsTest, ARestartFromAClearedStateForgetsWhatTheProcessRemembers) {
  robot_.machine.log.clear();
  EXPECT_TRUE(robot_.supervisor().Restart("nav", robot_.machine.now, true));
  robot_.RunFor(seconds(10));
  EXPECT_THAT(robot_.machine.log, ElementsAre("end nav", "clear nav"));
  EXPECT_TRUE(robot_.AllReady());
}

TEST_F(SupervisorRequestsTest, TheRestartAfterThatKeepsItsState) {
  EXPECT_TRUE(robot_.supervisor().Restart("nav", robot_.machine.now, true));
  robot_.RunFor(seconds(100));
  robot_.machine.log.clear();
  robot_.machine.Crash("nav");
  robot_.RunFor(seconds(100));
  EXPECT_TRUE(robot_.AllReady());
  EXPECT_THAT(robot_.machine.log, ElementsAre());
}

TEST_F(SupervisorRequestsTest, AtAnotherSiteEverythingBeginsAnewInTheConfigurationOfThatSite) {
  ASSERT_TRUE(Configure("mapping", Hand::kPerson));
  ASSERT_TRUE(Move("hill"));
  const SupervisorMemory memory = robot_.supervisor().Remember();
  EXPECT_EQ(memory.site, "hill");
  EXPECT_EQ(memory.configuration, "");  // that of the site
  EXPECT_FALSE(memory.manual);
  EXPECT_FALSE(memory.new_stack);  // the starts are no restarts
  robot_.RunFor(seconds(30));
  EXPECT_EQ(robot_.stacks, 1);
}

TEST_F(SupervisorRequestsTest, UntilItHasChangedTheMemoryHoldsTheOldSiteWithAllElse) {
  ASSERT_TRUE(Configure("safe", Hand::kPerson));
  const SupervisorMemory memory = robot_.supervisor().Remember();
  EXPECT_EQ(memory.site, "home");
  EXPECT_EQ(memory.configuration, "safe");
}

TEST_F(SupervisorRequestsTest, ASiteIsNotChangedToWhatIsUnknownOrNotComplete) {
  EXPECT_THAT(Move("hil").problem(), HasSubstr("did you mean \"hill\"?"));
  const auto not_complete = robot_.supervisor().SetSite(
      "hill", Hand::kPerson, [](const std::string&) { return Outcome(Problem{"no map"}); });
  EXPECT_EQ(not_complete.problem(), "no map");
  EXPECT_EQ(Move("home").value(), "the robot is at home already");
  EXPECT_EQ(robot_.supervisor().Remember().site, "home");
  robot_.RunFor(seconds(10));
  EXPECT_EQ(robot_.stacks, 0);
}

TEST_F(SupervisorRequestsTest, ATreeDoesNotChangeTheSiteWhileAPersonHoldsTheConfiguration) {
  ASSERT_TRUE(Configure("mapping", Hand::kPerson));
  EXPECT_THAT(Move("hill", Hand::kTree).problem(), HasSubstr("held by hand"));
  robot_.supervisor().Release();
  EXPECT_TRUE(Move("hill", Hand::kTree));
}

TEST_F(SupervisorRequestsTest, NobodyChangesTheSiteInASafeStop) {
  GiveUpNav();
  EXPECT_THAT(Move("hill").problem(), HasSubstr("safe stop"));
}

}  // namespace
}  // namespace coppice::robot::processes
