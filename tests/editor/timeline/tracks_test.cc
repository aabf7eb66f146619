#include "editor/timeline/tracks.h"

#include <gtest/gtest.h>

#include "editor/timeline/run.h"
#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {
namespace {

constexpr char kTrees[] = R"(<BehaviorTree ID="Main"><ReactiveSequence>
  <Is as="ready"/><Do as="work" count="{count}"/></ReactiveSequence></BehaviorTree>)";

class TracksTest : public testing::Test {
 protected:
  ExecutedTree robot{kTrees};
  coppice::editor::Run run;
  Follow follow{robot.executor, run};
};

TEST_F(TracksTest, ATickShowsWhatANodeReturnedInItAlsoIfItIsIdleAtItsEnd) {
  for (int i = 0; i < 3; ++i) robot.Tick();
  const Tracks& tracks = run.TracksAt(0);
  EXPECT_EQ(tracks.LaneOf(NodeIndex{1}).At(2), Status::kSuccess);
  EXPECT_EQ(tracks.LaneOf(NodeIndex{1}).changes(), 1U)
      << "three ticks with the same result are one bar";
  EXPECT_EQ(run.now().status(NodeIndex{1}), Status::kIdle);
}

TEST_F(TracksTest, ANodeThatIsNotTickedFallsBackToTheStatusThatItHas) {
  robot.Tick();
  robot.results["ready"] = Status::kFailure;
  robot.Tick();
  EXPECT_EQ(run.TracksAt(1).LaneOf(NodeIndex{2}).At(0), Status::kSuccess);
  EXPECT_EQ(run.TracksAt(1).LaneOf(NodeIndex{2}).At(1), Status::kIdle);
  EXPECT_EQ(run.TracksAt(1).LaneOf(NodeIndex{1}).At(1), Status::kFailure);
}

TEST(Tracks, ASleepThatIsRepeatedStartsAnewWhereItEnds) {
  ExecutedTree robot(R"(<BehaviorTree ID="Main"><Repeat num_cycles="-1">
    <Sleep msec="400"/></Repeat></BehaviorTree>)");
  coppice::editor::Run run;
  const Follow follow(robot.executor, run);
  for (int i = 0; i < 8; ++i) robot.Tick();
  const Lane& lane = run.TracksAt(0).LaneOf(NodeIndex{1});
  EXPECT_EQ(lane.At(7), Status::kRunning);
  EXPECT_GE(lane.Since(7), 4U);
}

TEST_F(TracksTest, KnowsEveryWriteWithWriterAndValue) {
  for (int i = 0; i < 3; ++i) robot.Tick();
  const Tracks& tracks = run.TracksAt(0);
  SlotIndex slot{0};
  while (tracks.tree()->slots[slot].name != "count") ++slot;
  const auto& writes = tracks.WritesOf(slot);
  ASSERT_EQ(writes.size(), 3U);
  EXPECT_EQ(writes[1].tick, 1U);
  const Event event = run.EventAt(writes[1]);
  EXPECT_EQ(event.code, EventCode::kWrite);
  EXPECT_EQ(event.writer, 2U);
  EXPECT_EQ(PrintValueBytes(event.bytes), "2");
}

TEST_F(TracksTest, GoOnWhenTheRobotHasMadeAnotherKey) {
  Tracks tracks(run.TracksAt(0).tree());
  TreeDescription more = *tracks.tree();
  more.slots.push_back({"Main", "new", "any", true});
  EXPECT_TRUE(tracks.GoOnAs(std::make_shared<const TreeDescription>(more)));
  EXPECT_TRUE(tracks.WritesOf(static_cast<SlotIndex>(more.slots.size() - 1)).empty());
  more.nodes[1].path = "other";
  EXPECT_FALSE(tracks.GoOnAs(std::make_shared<const TreeDescription>(more)));
}

}  // namespace
}  // namespace coppice::editor
