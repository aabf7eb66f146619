#include "bt_core/engine/events/status_follower.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

constexpr Status kIdle = Status::kIdle;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;
using Statuses = std::vector<Status>;

Event Of(std::uint32_t node, Status status) {
  Event event;
  event.code = static_cast<EventCode>(status);
  event.index = node;
  return event;
}

// 0 sequence (1 a, 2 parallel (3 b, 4 c), 5 d)
StatusFollower Follower() {
  return StatusFollower({{NodeIndex{0}, NodeIndex{6}, true},
                         {NodeIndex{0}, NodeIndex{2}, false},
                         {NodeIndex{0}, NodeIndex{5}, false},
                         {NodeIndex{2}, NodeIndex{4}, false},
                         {NodeIndex{2}, NodeIndex{5}, false},
                         {NodeIndex{0}, NodeIndex{6}, false}},
                        Statuses(6, kIdle));
}

TEST(StatusFollower, WhenANodeEndsItsChildrenAreIdle) {
  StatusFollower follower = Follower();
  follower.Apply(Of(3, kSuccess));
  follower.Apply(Of(4, kSuccess));
  EXPECT_EQ(follower.status(NodeIndex{4}), kSuccess);
  follower.Apply(Of(2, kSuccess));
  EXPECT_EQ(follower.statuses(), (Statuses{kIdle, kIdle, kSuccess, kIdle, kIdle, kIdle}));
  EXPECT_EQ(follower.last(NodeIndex{4}), kSuccess);
}

TEST(StatusFollower, BehindTheRunningChildOfASequenceAllAreIdle) {
  StatusFollower follower = Follower();
  follower.Apply(Of(1, kSuccess));
  follower.Apply(Of(2, kSuccess));
  follower.Apply(Of(5, kRunning));
  follower.Apply(Of(0, kRunning));
  EXPECT_EQ(follower.statuses(), (Statuses{kRunning, kSuccess, kSuccess, kIdle, kIdle, kRunning}));
  follower.Apply(Of(1, kRunning));
  follower.Apply(Of(5, kIdle));
  follower.Apply(Of(0, kRunning));
  EXPECT_EQ(follower.statuses(), (Statuses{kRunning, kRunning, kIdle, kIdle, kIdle, kIdle}));
}

TEST(StatusFollower, WhatWasNotedFollowsWhenItIsSettled) {
  StatusFollower applied = Follower();
  StatusFollower noted = Follower();
  for (const Event& event : {Of(1, kSuccess), Of(3, kSuccess), Of(4, kRunning), Of(2, kRunning),
                             Of(0, kRunning), Of(1, kRunning), Of(2, kIdle), Of(0, kRunning)}) {
    applied.Apply(event);
    const std::uint32_t word = event.index << 3 | static_cast<std::uint32_t>(event.code);
    EXPECT_EQ(noted.Note(&word, &word + 1), &word + 1);
  }
  noted.Settle();
  EXPECT_EQ(noted.statuses(), applied.statuses());
  EXPECT_EQ(noted.lasts(), applied.lasts());
}

TEST(StatusFollower, ChangesComeInTheOrderOfHappening) {
  StatusFollower follower = Follower();
  std::vector<NodeIndex> nodes;
  for (const Event& event :
       {Of(3, kSuccess), Of(4, kRunning), Of(2, kRunning), Of(4, kSuccess), Of(2, kSuccess)}) {
    follower.Apply(event, [&](const StatusChange& change) { nodes.push_back(change.node); });
  }
  EXPECT_EQ(nodes, (std::vector<NodeIndex>{NodeIndex{3}, NodeIndex{4}, NodeIndex{2}, NodeIndex{4},
                                           NodeIndex{3}, NodeIndex{4}, NodeIndex{2}}));
}

TEST(StatusFollower, AnEventOfANodeThatThereIsNotChangesNothing) {
  StatusFollower follower = Follower();
  follower.Apply(Of(6, kRunning));
  EXPECT_EQ(follower.statuses(), Statuses(6, kIdle));
}

TEST(StatusFollower, KnowsWhatTheExecutorKnows) {
  LeafScript script;
  script.results = {{"a", {kSuccess, kRunning, kSuccess, Status::kFailure}},
                    {"b", {kRunning, Status::kFailure, kSuccess, Status::kSkipped}},
                    {"c", {Status::kFailure, kRunning, kRunning, kSuccess}}};
  for (const std::string outer : {"Sequence", "Fallback", "ReactiveSequence", "ReactiveFallback"}) {
    for (const std::string inner : {"Sequence", "SequenceWithMemory", "ReactiveFallback",
                                    "Parallel", "WorstOf", "PipelineSequence"}) {
      Stage stage(Main("<" + outer + "><" + inner + R"(><Leaf name="a"/><Leaf name="b"/></)" +
                       inner + R"(><Inverter><Leaf name="c"/></Inverter></)" + outer + ">"),
                  script);
      const KeepingSink& sink = stage.Listen();
      for (std::size_t i = 0; i < 12; ++i) {
        stage.executor->Tick();
        for (const StatusChange& change : sink.ticks[i].changes) {
          EXPECT_NE(change.from, change.to);
        }
        EXPECT_EQ(sink.statuses(), stage.executor->statuses()) << outer << " " << inner << i;
      }
    }
  }
}

}  // namespace
}  // namespace coppice
