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

// The same tree without a sink and with one, which makes the executor write down every reset.
void ExpectTheSameStatusesWithAndWithoutSink(const std::string& body, const LeafScript& script,
                                             int ticks) {
  Stage alone(Main(body), script);
  Stage watched(Main(body), script);
  watched.Listen();
  for (int i = 0; i < ticks; ++i) {
    EXPECT_EQ(alone.executor->Tick(), watched.executor->Tick());
    EXPECT_EQ(alone.executor->statuses(), watched.executor->statuses()) << "tick " << i + 1;
  }
}

TEST(Tick, ChildrenOfAnEndedNodeAreIdle) {
  Stage stage(
      Main("<Sequence><Leaf name=\"a\"/><Fallback><Leaf name=\"b\"/></Fallback></Sequence>"));
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.executor->statuses(), (Statuses{kSuccess, kIdle, kIdle, kIdle}));
}

TEST(Tick, ChildrenBehindTheRunningOneAreIdleAlsoInALaterActivation) {
  Stage stage(Main("<Sequence><Leaf name=\"a\"/><Leaf name=\"b\"/></Sequence>"),
              Results({{"a", {kSuccess, kRunning}}, {"b", {kSuccess}}}));
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->statuses(), (Statuses{kRunning, kRunning, kIdle}));
}

TEST(Tick, StatusesDoNotDependOnWhetherSomeoneListens) {
  const LeafScript script = Results({{"a", {kSuccess, kRunning, kSuccess, kFailure}},
                                     {"b", {kRunning, kFailure, kSuccess}},
                                     {"c", {kFailure, kRunning, kRunning, kSuccess}}});
  for (const std::string outer : {"Sequence", "Fallback", "ReactiveSequence", "ReactiveFallback"}) {
    for (const std::string inner : {"Sequence", "Fallback", "ReactiveFallback", "Parallel"}) {
      ExpectTheSameStatusesWithAndWithoutSink(
          "<" + outer + "><" + inner + "><Leaf name=\"a\"/><Leaf name=\"b\"/></" + inner +
              "><Inverter><Leaf name=\"c\"/></Inverter></" + outer + ">",
          script, 12);
    }
  }
}

TEST(Tick, ASinkThatComesLateSeesTheRightStatuses) {
  Stage stage(Main("<Sequence><Leaf name=\"a\"/><Leaf name=\"b\"/></Sequence>"),
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
