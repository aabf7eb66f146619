#include "bt_core/live/server/live_sessions.h"

#include "tests/bt_core/live/desk_fixture.h"

namespace coppice {
namespace {

using ::testing::SizeIs;

class LiveSessionsTest : public LiveTreeFixture {
 protected:
  LiveTrees trees_{{0, tree_}};
  LiveSessions sessions_{trees_};
};

TEST_F(LiveSessionsTest, GivesEachClientAnOwnerOfItsOwn) {
  const OwnerId first = sessions_.Open(kAnn, true, Duration(1))->owner;
  EXPECT_NE(sessions_.Open(kBen, true, Duration(1))->owner, first);
  EXPECT_EQ(sessions_.Find(kAnn)->owner, first);
  EXPECT_GT(first, LiveTree::kGroot2Owner);
  EXPECT_EQ(sessions_.Find(kCem), nullptr);
}

TEST_F(LiveSessionsTest, ReleasesWhatAClientHoldsWhenItIsClosed) {
  Session* const session = sessions_.Open(kAnn, true, Duration(1));
  Hook hook;
  hook.node = NodeIndex{1};
  EXPECT_TRUE(tree_->debugger().Add(hook, session->owner));
  EXPECT_TRUE(tree_->debugger().Add(hook, session->owner + 100));
  sessions_.Close(kAnn);
  sessions_.Close(kAnn);
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(1));
  EXPECT_EQ(sessions_.Find(kAnn), nullptr);
}

TEST_F(LiveSessionsTest, OpeningAgainReleasesToo) {
  Hook hook;
  hook.node = NodeIndex{1};
  EXPECT_TRUE(tree_->debugger().Add(hook, sessions_.Open(kAnn, true, Duration(1))->owner));
  sessions_.Open(kAnn, true, Duration(2));
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(0));
}

TEST_F(LiveSessionsTest, AreNotEndlesslyMany) {
  for (std::size_t i = 0; i < LiveSessions::kMaxSessions; ++i) {
    EXPECT_NE(sessions_.Open(ClientId(i), true, Duration(1)), nullptr);
  }
  EXPECT_EQ(sessions_.Open(ClientId(LiveSessions::kMaxSessions), true, Duration(1)), nullptr);
  EXPECT_NE(sessions_.Open(ClientId(0), true, Duration(1)), nullptr) << "in place of its own";
}

TEST_F(LiveSessionsTest, ReadersLeavePlacesToWhoMayControl) {
  std::uint64_t client = 0;
  while (sessions_.Open(ClientId(client), false, Duration(1))) ++client;
  EXPECT_EQ(client, LiveSessions::kMaxReaders);
  EXPECT_NE(sessions_.Open(ClientId(client), true, Duration(1)), nullptr);
}

TEST_F(LiveSessionsTest, ForgetsSubscriptionsOfATreeThatGoes) {
  Session* const session = sessions_.Open(kAnn, true, Duration(1));
  session->subscriptions.try_emplace(1, tree_, Subscription::From::kOldest, 0, 1000);
  sessions_.Forget(*tree_);
  EXPECT_THAT(session->subscriptions, SizeIs(0));
}

}  // namespace
}  // namespace coppice
