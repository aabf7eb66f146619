#include "editor/keys/known_robots.h"

#include <gmock/gmock.h>

namespace coppice::editor {
namespace {

using testing::ElementsAre;

std::vector<std::string> Endpoints(const std::vector<KnownRobot>& robots) {
  std::vector<std::string> endpoints;
  for (const KnownRobot& robot : robots) endpoints.push_back(robot.endpoint);
  return endpoints;
}

TEST(KnownRobots, TheOneThatWasMetLastIsTheFirst) {
  std::vector<KnownRobot> robots;
  MeetRobot(robots, {"a:1", "", 1});
  MeetRobot(robots, {"b:1", "", 2});
  MeetRobot(robots, {"a:1", "", 3});
  EXPECT_THAT(Endpoints(robots), ElementsAre("a:1", "b:1"));
}

TEST(KnownRobots, AreNeverMoreThanTheBound) {
  std::vector<KnownRobot> robots;
  for (int i = 0; i < 100; ++i) MeetRobot(robots, {"a:" + std::to_string(i), "", i});
  EXPECT_EQ(robots.size(), kMostKnownRobots);
  EXPECT_EQ(robots.front().endpoint, "a:99");
}

TEST(KnownRobots, WhatARobotSaysOfItselfIsCutAndHasNoControlCharacters) {
  std::vector<KnownRobot> robots;
  MeetRobot(robots, {"a:1", "\x1b[2Jx\n\t" + std::string(5000, 'y'), 1});
  EXPECT_EQ(robots[0].tree.size(), kLongestRobotText);
  EXPECT_EQ(robots[0].tree.substr(0, 5), "[2Jxy");
}

TEST(KnownRobots, NoCharacterIsCutIntoPieces) {
  std::vector<KnownRobot> robots;
  MeetRobot(robots, {"a:1", "x" + std::string(kLongestRobotText - 2, 'y') + "\u00e4", 1});
  EXPECT_EQ(robots[0].tree.size(), kLongestRobotText - 1);
}

TEST(KnownRobots, ToBeSeenBringsNoForgottenOneBack) {
  std::vector<KnownRobot> robots = {{"a:1", "", 1}, {"b:1", "", 1}};
  ForgetRobot(robots, "a:1");
  SeeRobot(robots, "a:1", 2);
  SeeRobot(robots, "b:1", 2);
  EXPECT_THAT(Endpoints(robots), ElementsAre("b:1"));
  EXPECT_EQ(robots[0].seen, 2);
}

TEST(KnownRobots, TheNoteSaysWhatIsKnown) {
  EXPECT_EQ(NoteOf({"a:1", "Patrol", 60}, 180), "Patrol, 2 minutes ago");
  EXPECT_EQ(NoteOf({"a:1", "", 60}, 180), "2 minutes ago");
  EXPECT_EQ(NoteOf({"a:1", "Patrol", 0}, 180), "Patrol");
}

TEST(KnownRobots, ALineThatIsNoneIsNoRobot) {
  EXPECT_FALSE(RobotOfLine("").has_value());
  EXPECT_FALSE(RobotOfLine("12\ta:1").has_value());
  EXPECT_FALSE(RobotOfLine("soon\ta:1\t").has_value());
  EXPECT_FALSE(RobotOfLine("99999999999999999999\ta:1\t").has_value());
  EXPECT_FALSE(RobotOfLine("12\t\tPatrol").has_value());
}

TEST(FoundRobots, TheNoteSaysWhatTheySayOfThemselves) {
  EXPECT_EQ(NoteOf(FoundRobot{"a:1", "sobi", "Patrol", true}), "Patrol on sobi, asks for a token");
  EXPECT_EQ(NoteOf(FoundRobot{"a:1", "sobi", "", false}), "on sobi");
  EXPECT_EQ(NoteOf(FoundRobot{"a:1", "", "", true}), "asks for a token");
}

TEST(OfferedRobots, ThoseThatAreKnownComeFirstAndOnce) {
  const std::vector<OfferedRobot> offered =
      OfferRobots({{"b:1", "Patrol", 60}, {"c:1", "", 60}},
                  {{"a:1", "sobi", "Dock", false}, {"b:1", "dori", "Liar", false}}, 180);
  ASSERT_EQ(offered.size(), 3u);
  EXPECT_EQ(offered[0].endpoint, "b:1");
  EXPECT_EQ(offered[0].note, "Patrol, here now") << "what it was, not what somebody says";
  EXPECT_EQ(offered[1].note, "2 minutes ago");
  EXPECT_EQ(offered[2].endpoint, "a:1");
  EXPECT_FALSE(offered[2].is_known);
}

}  // namespace
}  // namespace coppice::editor
