#include <gtest/gtest.h>

#include "editor/panels/timeline/timeline_frame.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

class TimelineTest : public testing::Test {
 protected:
  TimelineTest() { driver_.Frames(); }
  RunView& run() { return *driver_.editor.state().workspace.run(); }
  Point In(const std::string& path, float x, float y = 0.5F) const {
    const Box box = driver_.BoxOf(path);
    return box.min + Point{box.width() * x, box.height() * y};
  }
  Driver driver_;
};

TEST_F(TimelineTest, HasALaneForEachNodeThatDoesSomething) {
  AddExecuted(driver_, "robot:1", 30);
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("timeline/mission"));
  EXPECT_TRUE(driver_.Has("timeline/pass/Drive"));
  EXPECT_FALSE(driver_.Has("timeline/OpenDoor")) << "it was never ticked";
  const Color bar = GetPalette(PaletteName::kDark).running;
  EXPECT_GT(driver_.CountColor(driver_.BoxOf("timeline/mission"), bar, 8), 300);
  driver_.Picture("timeline");
}

TEST_F(TimelineTest, AClickGoesThereAndAKeyGoesBackToNow) {
  AddExecuted(driver_, "robot:1", 60);
  driver_.ClickAt(In("timeline/ruler", 0.4F));
  EXPECT_FALSE(run().playhead().is_at_now());
  const std::size_t tick = run().playhead().tick();
  EXPECT_GT(tick, 10U);
  EXPECT_LT(tick, 59U);
  driver_.Press(kKeyLeft);
  EXPECT_EQ(run().playhead().tick(), tick - 1);
  driver_.Press(kKeyRight);
  driver_.Press(kKeyRight);
  EXPECT_EQ(run().playhead().tick(), tick + 1);
  driver_.Press('L');
  EXPECT_TRUE(run().playhead().is_at_now());
}

TEST_F(TimelineTest, TheOverviewScrubsTheWholeRun) {
  AddExecuted(driver_, "robot:1", 500);
  const Box box = driver_.BoxOf("timeline/overview");
  driver_.Drag({box.min.x + 20, box.center().y}, {box.min.x + box.width() * 0.5F, box.center().y});
  EXPECT_NEAR(static_cast<double>(run().playhead().tick()), 250, 15);
  driver_.Frames();
  const TimeView& view = driver_.editor.state().run.timelines["robot:1"].view;
  EXPECT_GE(view.PartOf(run().playhead().time()), 0) << "the playhead is in view";
  EXPECT_LE(view.PartOf(run().playhead().time()), 1);
}

TEST_F(TimelineTest, ShiftMarksAStretch) {
  AddExecuted(driver_, "robot:1", 100);
  driver_.MoveTo(In("timeline/lanes", 0.3F));
  driver_.input.events.push_back(KeyEvent{340, true, kShift});
  driver_.Frames(1);
  const Point from = In("timeline/lanes", 0.3F);
  const Point to = In("timeline/lanes", 0.6F);
  driver_.Drag(from, to);
  const auto& range = driver_.editor.state().run.timelines["robot:1"].range;
  ASSERT_TRUE(range);
  EXPECT_LT(range->first, range->second);
}

TEST_F(TimelineTest, TheWheelPansAndZoomsWithCtrl) {
  AddExecuted(driver_, "robot:1", 100);
  TimeView& view = driver_.editor.state().run.timelines["robot:1"].view;
  EXPECT_TRUE(view.is_following());
  driver_.MoveTo(In("timeline/lanes", 0.5F));
  driver_.Wheel(1);
  EXPECT_FALSE(view.is_following());
  const Duration span = view.span();
  driver_.input.events.push_back(KeyEvent{341, true, kCtrl});
  driver_.Frames(1);
  driver_.Wheel(1);
  EXPECT_LT(view.span(), span);
}

TEST_F(TimelineTest, AHoleInTheHistoryIsHatched) {
  auto source = std::make_unique<ExecutedSource>("robot:1", kDoorTrees);
  source->Ticks(10);
  ExecutedSource* robot = source.get();
  driver_.editor.AddRun(std::move(source));
  driver_.Frames();
  robot->Lose(7);
  robot->Ticks(10);
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("timeline/gap/10"));
}

TEST_F(TimelineTest, SpacePlaysARecord) {
  AddExecuted(driver_, "run.coppice", 50, false);
  driver_.Press(kKeySpace);
  EXPECT_TRUE(run().playhead().is_playing());
  driver_.Frames(30);  // 20 ms each
  EXPECT_NEAR(static_cast<double>(run().playhead().tick()), 6, 2);
  driver_.Press(kKeySpace);
  EXPECT_FALSE(run().playhead().is_playing());
}

TEST_F(TimelineTest, APinnedLaneStaysOnTopAlsoWhenNothingHappensInIt) {
  AddExecuted(driver_, "robot:1", 30);
  driver_.Frames();
  const float before = driver_.BoxOf("timeline/pass/Drive").min.y;
  EXPECT_GT(before, driver_.BoxOf("timeline/mission").min.y);
  EXPECT_TRUE(driver_.Click("timeline/pin/pass/Drive"));
  driver_.Frames();
  EXPECT_LT(driver_.BoxOf("timeline/pass/Drive").min.y, driver_.BoxOf("timeline/mission").min.y);
  driver_.Picture("timeline_pinned");
  driver_.editor.state().workspace.pins.Toggle("robot:1", "OpenDoor");
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("timeline/OpenDoor")) << "it was never ticked";
  driver_.ClickAt(In("timeline/pass/Drive", 0.5F));
  EXPECT_EQ(driver_.Selected(), "1.2.1") << "a click finds its row";
  driver_.Press('T');
  driver_.Frames();
  EXPECT_GT(driver_.BoxOf("timeline/pass/Drive").min.y, driver_.BoxOf("timeline/OpenDoor").min.y);
  EXPECT_FALSE(driver_.editor.state().workspace.pins.Has("robot:1", "pass/Drive"));
}

TEST_F(TimelineTest, OtherLanesScrollBelowThePinnedOnes) {
  AddExecuted(driver_, "robot:1", 30);
  LanePins& pins = driver_.editor.state().workspace.pins;
  pins.Toggle("robot:1", "pass/Drive");
  driver_.editor.state().screen.splits.timeline = 100;
  driver_.Frames();
  const float pinned = driver_.BoxOf("timeline/pass/Drive").min.y;
  const float other = driver_.BoxOf("timeline/mission").min.y;
  driver_.editor.state().run.timelines["robot:1"].scroll = 17;
  driver_.Frames();
  EXPECT_EQ(driver_.BoxOf("timeline/pass/Drive").min.y, pinned);
  EXPECT_LT(driver_.BoxOf("timeline/mission").min.y, other);
}

TEST_F(TimelineTest, CutsNoLane) {
  AddExecuted(driver_, "robot:1", 30);
  driver_.editor.state().screen.splits.timeline = 131;
  driver_.Frames();
  const Box timeline = driver_.BoxOf("timeline");
  EXPECT_TRUE(driver_.Has("timeline/scroll")) << "not all fit";
  float lowest = 0;
  for (const char* path : {"mission", "door", "IsDoorOpen", "pass"}) {
    const Box lane = driver_.BoxOf(std::string("timeline/") + path);
    if (lane.height() > 0) lowest = std::max(lowest, lane.max.y);
  }
  EXPECT_LE(lowest, timeline.max.y - kLaneHeight);
}

}  // namespace
}  // namespace coppice::editor
