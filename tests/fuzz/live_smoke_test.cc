// The harnesses of what comes over the network, as smoke_test.cc does it for the others.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/regressions.h"
#include "tests/fuzz/seeds.h"

namespace coppice::fuzz {
namespace {

TEST(FuzzLive, MutatedRequestsNeverCrash) {
  const std::string requests = SomeRequests();
  const int good = FuzzLive(requests);
  EXPECT_GE(good, 30) << "the unchanged requests are good ones";
  int total = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    total += FuzzLive(Mutator(seed).Mutate(requests));
  }
  EXPECT_GT(total, 5000) << "many reach the tree";
}

// How often mutants of the input came how far.
std::array<int, 4> ReachedBy(const std::string& talk) {
  std::array<int, 4> reached{};
  for (unsigned seed = 0; seed < 10000; ++seed) ++reached[FuzzClient(Mutator(seed).Mutate(talk))];
  return reached;
}

TEST(FuzzClient, MutatedTalkNeverCrashes) {
  EXPECT_EQ(FuzzClient(SomeTalk()), 3);
  for (const int count : ReachedBy(SomeTalk())) EXPECT_GT(count, 50);
}

TEST(FuzzClient, MutatedTalkInTheGroot2ProtocolNeverCrashes) {
  EXPECT_EQ(FuzzClient(SomeGroot2Talk()), 3);
  const std::array<int, 4> reached = ReachedBy(SomeGroot2Talk());
  EXPECT_GT(reached[0], 50) << "tree and state come together";
  EXPECT_GT(reached[2], 50);
  EXPECT_GT(reached[3], 50);
}

TEST(FuzzDiscovery, MutatedMessagesNeverCrash) {
  EXPECT_EQ(FuzzDiscovery(SomeDiscoveryQuestion()), 2);
  EXPECT_EQ(FuzzDiscovery(SomeDiscoveryAnswer()), 1);
  std::array<int, 3> reached{};
  for (unsigned seed = 0; seed < 20000; ++seed) {
    ++reached[FuzzDiscovery(Mutator(seed).Mutate(SomeDiscoveryQuestion()))];
    ++reached[FuzzDiscovery(Mutator(seed).Mutate(SomeDiscoveryAnswer()))];
  }
  for (const int count : reached) EXPECT_GT(count, 100);
}

TEST(FuzzWeb, MutatedVisitorsDisturbNobody) {
  const std::string request = SomeWebRequest();
  const std::string messages = SomeWebMessages();
  EXPECT_EQ(FuzzWeb(request), 1);
  EXPECT_EQ(FuzzWeb(messages), 3);
  std::array<int, 4> reached{};
  for (unsigned seed = 0; seed < 1000; ++seed) {
    ++reached[FuzzWeb(Mutator(seed).Mutate(request))];
    ++reached[FuzzWeb(Mutator(seed).Mutate(messages))];
  }
  for (const int count : reached) EXPECT_GT(count, 20);
  EXPECT_EQ(FuzzWeb(messages), 3) << "it still serves";
}

class FuzzZmtpTest : public testing::TestWithParam<char> {};

TEST_P(FuzzZmtpTest, MutatedClientsNeverCrash) {
  const std::string talk = SomeZmtpTalk(GetParam());
  EXPECT_EQ(FuzzZmtp(talk), 3);
  std::array<int, 4> reached{};
  for (unsigned seed = 0; seed < 400; ++seed) ++reached[FuzzZmtp(Mutator(seed).Mutate(talk))];
  EXPECT_GT(reached[0], 5) << "some are not let in";
  EXPECT_GT(reached[3], 100) << "many reach the tree";
}

INSTANTIATE_TEST_SUITE_P(Kinds, FuzzZmtpTest, testing::Values('N', 'C', 'R'));

TEST(FuzzZmtp, AListenerIsLetIn) { EXPECT_EQ(FuzzZmtp(SomeZmtpTopics()), 1); }

class FuzzRobotTest : public testing::TestWithParam<char> {};

TEST_P(FuzzRobotTest, MutatedRobotsNeverCrashAClient) {
  const std::string talk = SomeZmtpRobot(GetParam());
  EXPECT_EQ(FuzzRobot(talk), 2);
  std::array<int, 3> reached{};
  for (unsigned seed = 0; seed < 2000; ++seed) ++reached[FuzzRobot(Mutator(seed).Mutate(talk))];
  EXPECT_GT(reached[0], 50) << "some are not believed";
  EXPECT_GT(reached[2], 500) << "many are heard";
}

INSTANTIATE_TEST_SUITE_P(Kinds, FuzzRobotTest, testing::Values('N', 'C', 'S'));

TEST(FuzzLive, EmptyInputIsFine) {
  EXPECT_EQ(FuzzLive(""), 0);
  EXPECT_EQ(FuzzClient(""), 0);
  EXPECT_EQ(FuzzDiscovery(""), 0);
  EXPECT_EQ(FuzzRobot(""), 0);
  EXPECT_EQ(FuzzWeb(""), 0);
  EXPECT_EQ(FuzzZmtp(""), 0);
}

// What once crashed must not do so again.
TEST(FuzzLive, WhatOnceCrashedDoesNotAnyMore) {
  RunRegressions("client", FuzzClient);
  RunRegressions("discovery", FuzzDiscovery);
  RunRegressions("live", FuzzLive);
  RunRegressions("robot", FuzzRobot);
  RunRegressions("web", FuzzWeb);
  RunRegressions("zmtp", FuzzZmtp);
}

}  // namespace
}  // namespace coppice::fuzz
