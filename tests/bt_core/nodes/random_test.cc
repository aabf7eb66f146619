#include "bt_core/nodes/random.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

// The leaves that a RandomSequence of a, b, c ticks in each activation.
std::vector<std::string> Orders(const std::string& seed, int activations) {
  Stage stage(Main("<RandomSequence seed=\"" + seed +
                   R"("><Leaf name="a"/><Leaf name="b"/><Leaf name="c"/></RandomSequence>)"));
  std::vector<std::string> orders;
  for (int i = 0; i < activations; ++i) {
    stage.executor->Tick();
    std::string order;
    for (const std::string& event : stage.TakeEvents()) order += event.back();
    orders.push_back(order);
  }
  return orders;
}

TEST(RandomSequence, TakesEachOrderEquallyOften) {
  std::map<std::string, int> counts;
  for (const std::string& order : Orders("7", 6000)) ++counts[order];
  ASSERT_EQ(counts.size(), 6U);
  for (const auto& [order, count] : counts) {
    EXPECT_EQ(std::set<char>(order.begin(), order.end()).size(), 3U) << order;
    EXPECT_NEAR(count, 1000, 150) << order;
  }
}

TEST(RandomSequence, DoesTheSameWithTheSameSeed) {
  EXPECT_EQ(Orders("1", 20), Orders("1", 20));
  EXPECT_NE(Orders("1", 20), Orders("2", 20));
}

TEST(RandomSelector, ResumesAtTheRunningChildAndStopsAtSuccess) {
  const Status r = Status::kRunning;
  const Status f = Status::kFailure;
  const Status s = Status::kSuccess;
  Stage stage(Main(R"(<RandomSelector><Leaf name="a"/><Leaf name="b"/></RandomSelector>)"),
              {{{"a", {r, f, f}}, {"b", {r, f, s}}}, {}, {}, {}});
  EXPECT_EQ(stage.executor->Tick(), r);
  EXPECT_EQ(stage.executor->Tick(), r);
  EXPECT_EQ(stage.executor->Tick(), f);
  const std::vector<std::string> events = stage.TakeEvents();
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(events[0].back(), events[1].back());
  EXPECT_EQ(events[2].back(), events[3].back());
  EXPECT_NE(events[1].back(), events[2].back());
  EXPECT_EQ(stage.executor->Tick(), s);
}

TEST(RandomSelector, IsSkippedIfAllChildrenAre) {
  const Status k = Status::kSkipped;
  Stage stage(Main(R"(<RandomSelector><Leaf name="a"/><Leaf name="b"/></RandomSelector>)"),
              {{{"a", {k}}, {"b", {k}}}, {}, {}, {}});
  EXPECT_EQ(stage.executor->Tick(), k);
  EXPECT_EQ(stage.TakeEvents().size(), 2U);
}

}  // namespace
}  // namespace coppice
