// What the fast way of ticking must not change: what is seen between ticks.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

constexpr Status kIdle = Status::kIdle;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;
using Statuses = std::vector<Status>;

LeafScript Results(std::map<std::string, std::vector<Status>> results) {
  LeafScript script;
  script.results = std::move(results);
  return script;
}

TEST(Tick, ChildrenOfAnEndedNodeAreIdle) {
  Stage stage(
      Main(R"(<Sequence><Leaf name="a"/><Fallback><Leaf name="b"/></Fallback></Sequence>)"));
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.executor->statuses(), (Statuses{kSuccess, kIdle, kIdle, kIdle}));
}

TEST(Tick, ChildrenBehindTheRunningOneAreIdleAlsoInALaterActivation) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"),
              Results({{"a", {kSuccess, kRunning}}, {"b", {kSuccess}}}));
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->statuses(), (Statuses{kRunning, kRunning, kIdle}));
}

TEST(Tick, ASinkThatComesLateSeesTheRightStatuses) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"),
              Results({{"a", {kSuccess, kRunning, kSuccess}}, {"b", {kSuccess, kRunning}}}));
  stage.executor->Tick();
  stage.executor->Tick();
  const KeepingSink& sink = stage.Listen();
  stage.executor->Tick();
  ASSERT_EQ(sink.ticks.size(), 1U);
  ASSERT_EQ(sink.ticks[0].changes.size(), 2U);
  EXPECT_EQ(sink.ticks[0].changes[0].from, kRunning);
  EXPECT_EQ(sink.ticks[0].changes[1].from, kIdle);
}

}  // namespace
}  // namespace coppice
