#include "bt_core/cli/live/live_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/cli/described_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;

class LiveSceneTest : public ::testing::Test {
 protected:
  LiveSceneTest() {
    keeper_.OnTree(SmallTree());
    keeper_.OnState(SmallState());
  }
  LiveScene Scene() {
    return keeper_.Look([](const LiveScene& scene) { return scene; });
  }

  LiveSceneKeeper keeper_;
};

TEST_F(LiveSceneTest, FollowsTheTree) {
  keeper_.OnTick(SmallTick().events());
  const LiveScene scene = Scene();
  EXPECT_EQ(scene.run.state()->status(NodeIndex{2}), Status::kRunning);
  EXPECT_EQ(scene.result, Status::kRunning);
  EXPECT_THAT(scene.texts, ElementsAre(R"(check: all is "well")"));
}

TEST_F(LiveSceneTest, KnowsWhetherTheTreeStands) {
  LiveNotice notice;
  notice.path = "check";
  notice.event.stop.where = DebugStop::Where::kBefore;
  keeper_.OnNotice(notice);
  EXPECT_EQ(Scene().stop, "stands before check");
  notice.event.stop.where = DebugStop::Where::kAfter;
  notice.event.stop.result = Status::kFailure;
  EXPECT_EQ(Describe(notice), "stands after check, which returned FAILURE");
  notice.event.stop.where = DebugStop::Where::kBetweenTicks;
  notice.event.stop.tick = 4;
  EXPECT_EQ(Describe(notice), "paused after tick 4");
  notice.event.kind = DebugEvent::Kind::kResumed;
  keeper_.OnNotice(notice);
  EXPECT_EQ(Scene().stop, "");
  notice.event.kind = DebugEvent::Kind::kRefused;
  notice.event.reason = "it moves";
  keeper_.OnNotice(notice);
  EXPECT_THAT(Scene().texts, ElementsAre("not stopped: it moves"));
}

TEST_F(LiveSceneTest, CountsWhatWasLostAndKeepsTheLastTexts) {
  HistoryGap gap;
  gap.lost_ticks = 5;
  keeper_.OnGap(gap);
  keeper_.OnGap(gap);
  EXPECT_EQ(Scene().lost_ticks, 10u);
  for (int i = 0; i < 9; ++i) keeper_.Say(std::to_string(i));
  EXPECT_THAT(Scene().texts, ElementsAre("4", "5", "6", "7", "8"));
}

TEST_F(LiveSceneTest, TellsThatSomethingHasChanged) {
  const std::uint64_t changes = Scene().changes;
  EXPECT_FALSE(keeper_.Wait(changes, Duration(0)));
  keeper_.OnTick(SmallTick().events());
  EXPECT_TRUE(keeper_.Wait(changes, Duration(0)));
}

}  // namespace
}  // namespace coppice
