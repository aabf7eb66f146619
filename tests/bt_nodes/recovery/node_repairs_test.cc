#include "bt_nodes/recovery/node_repairs.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

using std::chrono::seconds;

class NodeRepairsTest : public testing::Test {
 protected:
  std::vector<RepairOutcome> Blame(int at, const std::vector<std::string>& nodes) {
    now_ = Time(seconds(at));
    Health health;
    for (const std::string& node : nodes) {
      health.entries.push_back({"node", node, node, HealthLevel::kError, ""});
    }
    return repairs_.Update(now_, health, "node;topic");
  }
  std::string Next() {
    const auto next = repairs_.Next(now_);
    return next ? next->node : "";
  }

  Time now_{};
  NodeRepairs repairs_{{seconds(60), 3, seconds(600), seconds(60)}};
};

TEST_F(NodeRepairsTest, RestartsEveryFaultyNodeOnce) {
  Blame(0, {"/a", "/b"});
  EXPECT_EQ(Next(), "/a");
  repairs_.Began("/a", now_);
  EXPECT_EQ(Next(), "/b");
  repairs_.Began("/b", now_);
  EXPECT_EQ(Next(), "");
  EXPECT_TRUE(repairs_.is_busy());
  EXPECT_EQ(repairs_.given_up(), "");
}

TEST_F(NodeRepairsTest, IsDoneWhenTheNodeIsWell) {
  Blame(0, {"/a"});
  Next();
  repairs_.Began("/a", now_);
  const auto ended = Blame(5, {});
  ASSERT_EQ(ended.size(), 1u);
  EXPECT_TRUE(ended[0].is_well);
  EXPECT_FALSE(repairs_.is_busy());
  EXPECT_FALSE(repairs_.has_faults());
}

TEST_F(NodeRepairsTest, TriesAgainWhenTheNodeIsNotWellInTime) {
  Blame(0, {"/a"});
  Next();
  repairs_.Began("/a", now_);
  EXPECT_TRUE(Blame(59, {"/a"}).empty());
  EXPECT_EQ(Next(), "");
  const auto ended = Blame(60, {"/a"});
  ASSERT_EQ(ended.size(), 1u);
  EXPECT_FALSE(ended[0].is_well);
  EXPECT_EQ(Next(), "/a");
}

TEST_F(NodeRepairsTest, GivesUpWhatIsRefusedAndTriesItNowAndThen) {
  Blame(0, {"/a", "/b"});
  Next();
  repairs_.Refused("/a", now_);
  EXPECT_EQ(repairs_.given_up(), "/a");
  EXPECT_TRUE(repairs_.is_busy()) << "with /b";
  EXPECT_EQ(Next(), "/b");
  repairs_.Refused("/b", now_);
  EXPECT_FALSE(repairs_.is_busy());
  EXPECT_TRUE(repairs_.has_faults());
  EXPECT_EQ(repairs_.given_up(), "/a, /b");
  Blame(61, {"/a", "/b"});
  EXPECT_EQ(Next(), "/a");
}

// A node that crashes again and again after it was well for a moment.
TEST_F(NodeRepairsTest, GivesUpWhenTheBudgetIsUsedUpAlthoughItWasWellInBetween) {
  for (int i = 0; i < 3; ++i) {
    Blame(20 * i, {"/a"});
    EXPECT_EQ(Next(), "/a");
    repairs_.Began("/a", now_);
    Blame(20 * i + 10, {});
  }
  Blame(60, {"/a"});
  EXPECT_EQ(Next(), "");
  EXPECT_EQ(repairs_.given_up(), "/a");
  Blame(601, {"/a"});
  EXPECT_EQ(Next(), "/a") << "the first restart is long ago";
}

TEST_F(NodeRepairsTest, LeavesToAPersonWhatNoNodeIsKnownFor) {
  Health health;
  health.entries = {{"topic", "/scan", "", HealthLevel::kError, ""}};
  repairs_.Update(now_, health, "node;topic");
  EXPECT_EQ(Next(), "");
  EXPECT_FALSE(repairs_.is_busy());
  EXPECT_EQ(repairs_.given_up(), "/scan");
}

TEST_F(NodeRepairsTest, LooksOnlyAtErrorsOfItsKinds) {
  Health health;
  health.entries = {{"topic", "/scan", "/a", HealthLevel::kWarn, ""},
                    {"cpu", "host", "/b", HealthLevel::kError, ""},
                    {"topic", "/odom", "/c", HealthLevel::kStale, ""}};
  repairs_.Update(now_, health, "node;topic");
  EXPECT_EQ(Next(), "/c");
}

}  // namespace
}  // namespace coppice::leaves
