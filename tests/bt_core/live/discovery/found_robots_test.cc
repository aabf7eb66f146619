#include "bt_core/live/discovery/found_robots.h"

#include <gmock/gmock.h>

namespace coppice {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr Ipv4 kAddress = {192, 168, 1, 7};

RobotNotice At(std::uint16_t port, const std::string& tree = "Patrol") {
  return {"sobi", port, "sobi", tree, false};
}

TEST(FoundRobots, OneIsWhereItsAnswerComesFrom) {
  FoundRobots found;
  EXPECT_TRUE(found.Hear(kAddress, At(1667)));
  ASSERT_THAT(found.List(), SizeIs(1));
  EXPECT_EQ(found.List()[0].endpoint, "192.168.1.7:1667");
}

TEST(FoundRobots, WhoComesStandsBelowTheOthers) {
  FoundRobots found;
  found.Hear(kAddress, At(1667));
  found.Hear({10, 0, 0, 1}, At(1));
  EXPECT_EQ(found.List()[0].endpoint, "192.168.1.7:1667");
}

TEST(FoundRobots, WhatIsHeardAgainIsNoNews) {
  FoundRobots found;
  found.Hear(kAddress, At(1667));
  EXPECT_FALSE(found.Hear(kAddress, At(1667)));
  EXPECT_TRUE(found.Hear(kAddress, At(1667, "Docking")));
  EXPECT_EQ(found.List()[0].tree, "Docking");
}

TEST(FoundRobots, OneThatDoesNotAnswerAnyMoreIsGone) {
  FoundRobots found;
  found.Hear(kAddress, At(1667));
  for (int i = 0; i < FoundRobots::kPatience; ++i) EXPECT_FALSE(found.Ask());
  EXPECT_TRUE(found.Ask());
  EXPECT_THAT(found.List(), IsEmpty());
}

TEST(FoundRobots, OneThatAnswersNowAndThenStays) {
  FoundRobots found;
  for (int i = 0; i < 100; ++i) {
    if (i % FoundRobots::kPatience == 0) found.Hear(kAddress, At(1667));
    EXPECT_FALSE(found.Ask());
  }
}

TEST(FoundRobots, AComputerThatFloodsTakesItsOwnPlacesOnly) {
  FoundRobots found;
  for (std::uint16_t port = 1; port < 1000; ++port) found.Hear({10, 0, 0, 1}, At(port));
  EXPECT_THAT(found.List(), SizeIs(FoundRobots::kMostOfAddress));
  EXPECT_TRUE(found.Hear(kAddress, At(1667)));
}

TEST(FoundRobots, AreNeverMoreThanTheBound) {
  FoundRobots found;
  for (int i = 0; i < 1000; ++i) {
    found.Hear({10, 0, static_cast<std::uint8_t>(i / 250), static_cast<std::uint8_t>(i % 250)},
               At(1667));
  }
  EXPECT_THAT(found.List(), SizeIs(FoundRobots::kMost));
}

}  // namespace
}  // namespace coppice
