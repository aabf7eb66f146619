#include "editor/canvas/canvas.h"

#include <gtest/gtest.h>

#include <chrono>

#include "editor/canvas/paint/node_painter.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class CanvasTest : public testing::Test {
 protected:
  void OpenSmall() {
    ASSERT_TRUE(driver_.editor.Open(file_.path()));
    driver_.Frames();
  }
  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(CanvasTest, RegistersEveryVisibleNodeByPath) {
  OpenSmall();
  for (const char* path : {"1", "1.1", "1.1.1", "1.1.1.1", "1.1.2", "1.2", "1.2.1", "1.2.1.1"}) {
    EXPECT_TRUE(driver_.Has(std::string("canvas/MainTree/") + path)) << path;
  }
  driver_.Picture("small");
}

TEST_F(CanvasTest, SelectsTheNodeThatIsClicked) {
  OpenSmall();
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.1.2"));
  EXPECT_EQ(driver_.Selected(), "1.1.2");
  const Box box = driver_.BoxOf("canvas/MainTree/1.1.2");
  const Box around = {box.min - Point{6, 6}, box.max + Point{6, 6}};
  EXPECT_GT(driver_.CountColor(around, GetPalette(PaletteName::kDark).accent), 100);
}

TEST_F(CanvasTest, ClosesAndOpensASubTreeByItsToggle) {
  OpenSmall();
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.2/toggle"));
  driver_.Frames(12);
  EXPECT_FALSE(driver_.Has("canvas/MainTree/1.2.1"));
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.2/toggle"));
  driver_.Frames(12);
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.2.1.1"));
}

TEST_F(CanvasTest, PansWhenDraggedAndZoomsWithCtrlAndTheWheel) {
  OpenSmall();
  const Box before = driver_.BoxOf("canvas/MainTree/1");
  const Box canvas = driver_.BoxOf("canvas");
  const Point free = {canvas.min.x + 20, canvas.max.y - 20};
  driver_.Drag(free, free + Point{60, -40});
  const Box moved = driver_.BoxOf("canvas/MainTree/1");
  EXPECT_NEAR(moved.min.x, before.min.x + 60, 1);
  EXPECT_NEAR(moved.min.y, before.min.y - 40, 1);
  driver_.Zoom(-2);
  EXPECT_LT(driver_.BoxOf("canvas/MainTree/1").width(), moved.width());
}

TEST_F(CanvasTest, PaintsStatusesOnBordersInThreePalettes) {
  ScriptedRobot* const robot = driver_.AddRobot("robot:1", kLiveTree);
  robot->Set(1, Status::kRunning);
  robot->Set(2, Status::kSuccess);
  robot->Set(6, Status::kFailure);
  robot->Set(5, Status::kIdle, Status::kFailure);
  for (const PaletteName name :
       {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind}) {
    driver_.editor.state().screen.palette = name;
    driver_.Frames(30);
    const Palette& colors = GetPalette(name);
    EXPECT_GT(driver_.CountColor(driver_.BoxOf("canvas/Main/1"), colors.running), 60);
    EXPECT_GT(driver_.CountColor(driver_.BoxOf("canvas/Main/1.1"), colors.success), 60);
    EXPECT_GT(driver_.CountColor(driver_.BoxOf("canvas/Main/1.3"), colors.failure), 60);
    driver_.Picture(std::string("statuses_") + ToString(name));
  }
  const Palette& colors = GetPalette(PaletteName::kColourBlind);
  EXPECT_LT(driver_.CountColor(driver_.BoxOf("canvas/Main/1.2.1.1"), colors.failure), 20)
      << "the trail of an idle node must be weaker than the status";
}

TEST_F(CanvasTest, PaintsStatusesGreyedWhenTheRobotIsDown) {
  ScriptedRobot* const robot = driver_.AddRobot("robot:1", kLiveTree);
  robot->Set(1, Status::kRunning);
  driver_.Frames(3);
  const Color running = GetPalette(PaletteName::kDark).running;
  EXPECT_GT(driver_.CountColor(driver_.BoxOf("canvas/Main/1"), running), 60);
  robot->Disconnect("no answer");
  driver_.Frames(3);
  EXPECT_TRUE(driver_.Has("canvas/Main/1.2.1.1")) << "the last known tree stays";
  EXPECT_EQ(driver_.CountColor(driver_.BoxOf("canvas/Main/1"), running), 0);
}

TEST_F(CanvasTest, ShowsARunningDescendantOnTheCollapsedNode) {
  ScriptedRobot* const robot = driver_.AddRobot("robot:1", kLiveTree);
  robot->Set(5, Status::kRunning);
  driver_.view().SetCollapsed(1 + 1, true, driver_.editor.now());
  driver_.Frames(20);
  const Box chip = driver_.BoxOf("canvas/Main/1.2/toggle");
  const Palette& colors = GetPalette(PaletteName::kDark);
  const Color tint = Mix(colors.node_body, colors.running, 0.25F);
  EXPECT_GT(driver_.CountColor(chip, tint, 10), 100);
  EXPECT_FALSE(driver_.Has("canvas/Main/1.2.1"));
}

TEST_F(CanvasTest, MovesTheDotsAlongARunningEdge) {
  ScriptedRobot* const robot = driver_.AddRobot("robot:1", kLiveTree);
  robot->Set(1, Status::kRunning);
  robot->Set(3, Status::kRunning);
  driver_.Frames(10);
  const std::uint64_t before = HashOf(driver_.editor.Picture());
  driver_.Frames(5);
  EXPECT_NE(HashOf(driver_.editor.Picture()), before);
}

TEST_F(CanvasTest, PaintsTheSamePictureForTheSameEvents) {
  const auto run = [this] {
    Driver driver;
    driver.editor.Open(file_.path());
    ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
    robot->Set(1, Status::kRunning);
    driver.Click("canvas/Main/1.1");
    driver.Press('C');
    driver.Frames(20);
    return HashOf(driver.editor.Picture());
  };
  EXPECT_EQ(run(), run());
}

TEST_F(CanvasTest, ShowsLessDetailFromFarAway) {
  EXPECT_EQ(DetailFor(1), Detail::kFull);
  EXPECT_EQ(DetailFor(0.5F), Detail::kName);
  EXPECT_EQ(DetailFor(0.1F), Detail::kBlock);
  OpenSmall();
  for (const float zoom : {0.45F, 0.15F}) {
    driver_.view().camera.zoom = zoom;
    driver_.Frames();
    EXPECT_TRUE(driver_.Has("canvas/MainTree/1"));
    EXPECT_EQ(driver_.Has("canvas/MainTree/1.2/toggle"), zoom > 0.3F);
  }
}

TEST_F(CanvasTest, AddsToTheSelectionWithCtrlAndUpToWithShift) {
  OpenSmall();
  driver_.Click("canvas/MainTree/1.1.2");
  driver_.Hold(kCtrl);
  driver_.Click("canvas/MainTree/1.3");
  driver_.Hold(kNoModifier);
  EXPECT_EQ(driver_.view().selection().size(), 2U);
  driver_.Click("canvas/MainTree/1.1");
  driver_.Hold(kShift);
  driver_.Click("canvas/MainTree/1.3");
  driver_.Hold(kNoModifier);
  EXPECT_EQ(driver_.view().selection().size(), 3U);
}

TEST_F(CanvasTest, SelectsWhatIsInTheRectangle) {
  OpenSmall();
  const Box a = driver_.BoxOf("canvas/MainTree/1.1.1");
  const Box b = driver_.BoxOf("canvas/MainTree/1.1.2");
  driver_.Hold(kShift);
  driver_.Drag({a.min.x - 12, a.min.y - 4}, {b.max.x - 4, b.min.y + 10});
  driver_.Hold(kNoModifier);
  EXPECT_EQ(driver_.view().selection().size(), 2U);
  EXPECT_EQ(driver_.Selected(), "1.1.2");
}

TEST_F(CanvasTest, LightsAKeyAndDimsTheOthers) {
  OpenSmall();
  const Palette& colors = GetPalette(PaletteName::kDark);
  ASSERT_GT(driver_.CountColor(driver_.BoxOf("canvas/MainTree/1.1"), colors.control, 6), 100);
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.2/port/goal"));
  driver_.MoveTo({5, 5});
  EXPECT_LT(driver_.CountColor(driver_.BoxOf("canvas/MainTree/1.1"), colors.control, 6), 20);
  EXPECT_GT(driver_.CountColor(driver_.BoxOf("canvas/MainTree/1.2.1.1"), colors.OfKey("goal")),
            100);
  driver_.Picture("lit_key");
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.2/port/goal"));
  EXPECT_EQ(driver_.view().lit_key(), kNoKey);
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.2/port/goal"));
  EXPECT_NE(driver_.view().lit_key(), kNoKey);
  driver_.Press(kKeyEscape);
  EXPECT_EQ(driver_.view().lit_key(), kNoKey);
}

TEST_F(CanvasTest, ShowsCommentsAsNotes) {
  file_.Write(R"(<root BTCPP_format="4"><BehaviorTree ID="MainTree"><Sequence>
    <!-- needs the long pick --><AlwaysSuccess/></Sequence></BehaviorTree></root>)");
  OpenSmall();
  const Box note = driver_.BoxOf("canvas/MainTree/1.1/note");
  EXPECT_GT(driver_.CountColor(note, GetPalette(PaletteName::kDark).note), 500);
  EXPECT_GT(driver_.BoxOf("canvas/MainTree/1.1").min.y, note.min.y + 10);
}

// A tree of 20 000 nodes whose frame is built from what can be seen alone.
std::string LargeTree() {
  std::string xml = R"(<root BTCPP_format="4"><BehaviorTree ID="Large"><Sequence>)";
  for (int i = 0; i < 200; ++i) {
    xml += "<Fallback>";
    for (int j = 0; j < 33; ++j) {
      xml += R"(<Inverter><Go to="{place}" speed="0.4"/></Inverter><Wait seconds="2"/>)";
    }
    xml += "</Fallback>";
  }
  return xml + "</Sequence></BehaviorTree></root>";
}

TEST_F(CanvasTest, ShowsTwentyThousandNodes) {
  const TemporaryFile file("large.xml", LargeTree());
  ASSERT_TRUE(driver_.editor.Open(file.path()));
  driver_.Frames();
  ASSERT_GT(driver_.view().scene()->nodes.size(), 19900U);
  for (const bool close : {false, true}) {
    if (close) {
      driver_.view().Select(driver_.view().scene()->FindPath("1.100.30"));
      driver_.Press('Z');
      driver_.view().Reveal(driver_.editor.state().screen.canvas_size);
      driver_.Frames();
      EXPECT_GT(driver_.CountColor(driver_.BoxOf("canvas"), GetPalette(PaletteName::kDark).unknown),
                500);
    }
    double best = 1e9;
    for (int i = 0; i < 20; ++i) {
      const auto start = std::chrono::steady_clock::now();
      driver_.editor.Frame(driver_.input);
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - start;
      best = std::min(best, took.count());
    }
    RecordProperty(close ? "milliseconds_close" : "milliseconds_far", std::to_string(best));
    std::printf("frame of 20 000 nodes, %s: %.2f ms (budget 2)\n", close ? "zoom 100 %" : "fit",
                best);
  }
  driver_.Picture("large");
}

}  // namespace
}  // namespace coppice::editor
