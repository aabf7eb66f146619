#include "robot_app/assistance/page/page_access.h"

#include <gtest/gtest.h>

namespace coppice::robot::assistance {
namespace {

using std::chrono::hours;
using std::chrono::seconds;

constexpr const char* kHere = "192.0.2.1";
constexpr const char* kElsewhere = "192.0.2.2";

class Access : public testing::Test {
 protected:
  PageAccess access_{"an operator's token", "a viewer's token"};
  Time now_{hours(1000)};
};

TEST_F(Access, ALinkWorksOnceAndSaysWhoCame) {
  const std::string token = access_.MakeLinkToken("Ada", 7, now_);
  const Expected<PageAccess::Entry> entry = access_.LogIn(token, kHere, now_);
  ASSERT_TRUE(entry) << entry.problem();
  EXPECT_EQ(entry->pass.name, "Ada");
  EXPECT_EQ(entry->pass.request, 7u);
  EXPECT_EQ(entry->pass.role, PageRole::kOperator);
  EXPECT_FALSE(access_.LogIn(token, kHere, now_));
}

TEST_F(Access, ASessionLastsForEightHours) {
  const std::string session = access_.LogIn("an operator's token", kHere, now_)->session;
  EXPECT_TRUE(access_.Find(session, now_ + hours(8) - seconds(1)));
  EXPECT_FALSE(access_.Find(session, now_ + hours(8)));
  EXPECT_FALSE(access_.Find("", now_));
  EXPECT_FALSE(access_.Find(session + "0", now_));
}

TEST_F(Access, ALinkEndsWithItsTimeOrItsRequest) {
  const std::string old = access_.MakeLinkToken("Ada", 7, now_);
  EXPECT_FALSE(access_.LogIn(old, kHere, now_ + PageAccess::kLinkLifetime));
  const std::string closed = access_.MakeLinkToken("Ada", 7, now_);
  const std::string other = access_.MakeLinkToken("Ada", 8, now_);
  access_.EndLinks(7);
  EXPECT_FALSE(access_.LogIn(closed, kHere, now_));
  EXPECT_TRUE(access_.LogIn(other, kHere, now_));
}

TEST_F(Access, TokensOfTheConfigurationHaveRoles) {
  EXPECT_EQ(access_.LogIn("a viewer's token", kHere, now_)->pass.role, PageRole::kViewer);
  EXPECT_EQ(access_.LogIn("an operator's token", kHere, now_)->pass.role, PageRole::kOperator);
  EXPECT_TRUE(access_.LogIn("an operator's token", kHere, now_));
}

TEST_F(Access, WithoutTokensInTheConfigurationAnEmptyOneLetsNobodyIn) {
  PageAccess access;
  EXPECT_FALSE(access.LogIn("", kHere, now_));
}

TEST_F(Access, WhoLogsOutHasNoSessionAnyMore) {
  const std::string session = access_.LogIn("an operator's token", kHere, now_)->session;
  access_.LogOut(session);
  EXPECT_FALSE(access_.Find(session, now_));
}

TEST_F(Access, GuessingIsSlowedDownAtTheAddressThatItComesFrom) {
  const std::string first = access_.LogIn("guess", kHere, now_).problem();
  for (std::size_t i = 1; i < PageAccess::kMostFailures; ++i) {
    EXPECT_EQ(access_.LogIn("guess", kHere, now_).problem(), first);
  }
  EXPECT_NE(access_.LogIn("guess", kHere, now_).problem(), first);
  EXPECT_EQ(access_.LogIn("guess", kElsewhere, now_).problem(), first);
  EXPECT_EQ(access_.LogIn("guess", kHere, now_ + seconds(60)).problem(), first);
}

TEST_F(Access, WrongTokensKeepNobodyOutWhoHasARightOne) {
  const std::string link = access_.MakeLinkToken("Ada", 7, now_);
  for (std::size_t i = 0; i < 2 * PageAccess::kMostKeptFailures; ++i) {
    EXPECT_FALSE(access_.LogIn("guess", i % 2 == 0 ? kHere : std::to_string(i), now_));
  }
  EXPECT_EQ(access_.LogIn(link, kHere, now_)->pass.name, "Ada");
  EXPECT_TRUE(access_.LogIn("an operator's token", kHere, now_));
}

TEST_F(Access, ThereAreOnlySoManySessions) {
  const std::string first = access_.LogIn("a viewer's token", kHere, now_)->session;
  for (std::size_t i = 0; i < PageAccess::kMostSessions; ++i) {
    EXPECT_TRUE(access_.LogIn("a viewer's token", kHere, now_ + seconds(1)));
  }
  EXPECT_FALSE(access_.Find(first, now_ + seconds(1)));
  EXPECT_EQ(access_.state().sessions.size(), PageAccess::kMostSessions);
}

TEST_F(Access, ViewersPushNoOperatorOut) {
  const std::string driver = access_.LogIn("an operator's token", kHere, now_)->session;
  for (std::size_t i = 0; i < 2 * PageAccess::kMostSessions; ++i) {
    EXPECT_TRUE(access_.LogIn("a viewer's token", kElsewhere, now_ + seconds(1)));
  }
  EXPECT_TRUE(access_.Find(driver, now_ + seconds(1)));
}

TEST_F(Access, OutlivesTheProgramWithoutKeepingSecrets) {
  const std::string link = access_.MakeLinkToken("Ada", 7, now_);
  const std::string session = access_.LogIn("an operator's token", kHere, now_)->session;
  for (const auto& [hash, pass] : access_.state().links) EXPECT_NE(hash, link);
  PageAccess later;
  later.Restore(access_.state());
  EXPECT_TRUE(later.Find(session, now_));
  EXPECT_EQ(later.LogIn(link, kHere, now_)->pass.name, "Ada");
}

}  // namespace
}  // namespace coppice::robot::assistance
