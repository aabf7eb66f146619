#include "bt_core/frames/follower.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/frames/kept_history.h"
#include "tests/bt_core/frames/scripted_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;

class FollowingListener : public EventListener {
 public:
  explicit FollowingListener(const Program& program) : shape_(ShapeOf(program)) {}
  void OnState(const StreamState& s) override {
    follower.emplace(shape_, HistoryState{{}, s.tick, s.time, s.statuses, {}, s.values});
  }
  void OnTick(const TickEvents& events) override { follower->Apply(events); }
  std::optional<HistoryFollower> follower;

 private:
  TreeShape shape_;
};

TEST(HistoryFollower, KnowsStatusesAndValues) {
  LeafScript script;
  SimulatedClock clock;
  Executor executor(ScriptedProgram(script), clock);
  EventStream stream(executor);
  FollowingListener listener(executor.program());
  stream.Add(listener);
  std::mt19937 random(12);
  for (int i = 0; i < 1000; ++i) {
    TickAtRandom(random, script, clock, executor);
    stream.Flush();
    ASSERT_EQ(listener.follower->statuses(), executor.statuses());
    ASSERT_EQ(listener.follower->tick(), executor.ticks());
    ASSERT_EQ(listener.follower->time(), clock.Now());
    for (SlotIndex slot{0}; slot < executor.blackboard().size(); ++slot) {
      ASSERT_EQ(PrintValueBytes(listener.follower->values()[slot]),
                executor.blackboard()[slot].value.has_value()
                    ? executor.blackboard()[slot].value.Print()
                    : "");
    }
  }
  stream.Remove(listener);
}

TEST(HistoryFollower, RemembersTheLastStatusOfIdleNodes) {
  const TreeShape shape{{NodeIndex{0}, NodeIndex{2}, false}, {NodeIndex{0}, NodeIndex{2}, false}};
  HistoryFollower follower(shape, {{}, 0, Time{}, {Status::kIdle, Status::kIdle}, {}, {}});
  EventWriter words;
  words.Status(NodeIndex{1}, Status::kFailure);
  words.Status(kRootNode, Status::kSuccess);
  follower.Apply({1, Time(Duration(1)), Duration(0), Status::kSuccess, true, words.words()});
  EXPECT_EQ(follower.status(NodeIndex{1}), Status::kIdle);
  EXPECT_EQ(follower.last(NodeIndex{1}), Status::kFailure);
  const HistoryState state = follower.State(HistoryState::Cause::kKeyframe);
  EXPECT_THAT(state.last, ElementsAre(Status::kSuccess, Status::kFailure));
  EXPECT_EQ(HistoryFollower(shape, state).last(NodeIndex{1}), Status::kFailure);
  EXPECT_THAT(follower.LastsWith({Status::kIdle, Status::kRunning}),
              ElementsAre(Status::kSuccess, Status::kRunning));
}

void AddAnyStatuses(std::mt19937& random, EventWriter& words) {
  for (int i = 0; i < 12; ++i) {
    words.Status(static_cast<NodeIndex>(random() % 6), static_cast<Status>(random() % 5));
  }
}

// 0 sequence (1 a, 2 parallel (3 b, 4 c), 5 d), and events that no executor would make, too.
TEST(HistoryFollower, EventsThatHaveChangedNothingWhenTheyCameAgainNeverWill) {
  const TreeShape shape{{NodeIndex{0}, NodeIndex{6}, true},  {NodeIndex{0}, NodeIndex{2}, false},
                        {NodeIndex{0}, NodeIndex{5}, false}, {NodeIndex{2}, NodeIndex{4}, false},
                        {NodeIndex{2}, NodeIndex{5}, false}, {NodeIndex{0}, NodeIndex{6}, false}};
  std::mt19937 random(1);
  int settled = 0;
  for (int round = 0; round < 5000; ++round) {
    HistoryFollower follower(shape, {{}, 0, Time{}, std::vector<Status>(6), {}, {}});
    EventWriter before;
    AddAnyStatuses(random, before);
    follower.Apply({1, Time(Duration(1)), Duration(0), Status::kSuccess, true, before.words()});
    EventWriter words;
    AddAnyStatuses(random, words);
    const TickEvents events{2,    Time(Duration(2)), Duration(0), Status::kSuccess,
                            true, words.words()};
    follower.Apply(events);
    if (!follower.ApplyAgain(events)) continue;
    ++settled;
    const std::vector<Status> statuses = follower.statuses();
    follower.Apply(events);
    ASSERT_EQ(follower.statuses(), statuses) << round;
  }
  EXPECT_GT(settled, 4000);
}

TEST(HistoryFollower, TellsChangesAndEvents) {
  HistoryFollower follower({{NodeIndex{0}, NodeIndex{1}, false}},
                           {{}, 0, Time{}, {Status::kIdle}, {}, {}});
  EventWriter words;
  words.Text(kRootNode, EventText::kMessage, "hello");
  words.Status(kRootNode, Status::kSuccess);
  int changes = 0;
  int events = 0;
  follower.Apply(
      {1, Time(Duration(1)), Duration(0), Status::kSuccess, true, words.words()},
      [&](const StatusChange&) { ++changes; }, [&](const Event&) { ++events; });
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(events, 2);
}

}  // namespace
}  // namespace coppice
