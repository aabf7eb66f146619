#include "editor/canvas/tree_lines.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr int kLeaves = 30;  // in two columns
constexpr int kFirst = 2;    // uid of the first leaf
constexpr int kMiddle = 10;

std::string WideTree() {
  std::string xml = R"(<root BTCPP_format="4"><BehaviorTree ID="Main" _fullpath="">)"
                    R"(<Sequence name="top" _uid="1">)";
  for (int i = 0; i < kLeaves; ++i) {
    xml += R"(<Step name="s" _uid=")" + std::to_string(i + 2) + "\"/>";
  }
  return xml + "</Sequence></BehaviorTree></root>";
}

class TreeLines : public testing::Test {
 protected:
  TreeLines() {
    driver_.editor.state().screen.reduce_motion = true;
    LayoutStyle style;
    style.growth = Growth::kDown;
    style.wrapped = false;
    style.stacked = true;
    driver_.editor.state().workspace.SetStyle(style, 0);
    robot_ = driver_.AddRobot("robot:1", WideTree());
    driver_.Frames(20);
  }

  // Where nothing but the lines to all leaves begins.
  Box BelowTheParent() const {
    const Box parent = driver_.BoxOf("canvas/Main/1");
    const Box first = driver_.BoxOf("canvas/Main/1.1");
    return {{first.min.x - 8, parent.max.y + 2}, {parent.max.x, first.min.y - 4}};
  }

  int PixelsBelowTheParent(Color color) { return driver_.CountColor(BelowTheParent(), color, 12); }

  // From kIdle on, so that no trail of another leaf is there.
  int RunningPixelsWith(std::uint16_t leaf) {
    robot_->Set(leaf, Status::kRunning);
    driver_.Frames(200);
    driver_.Picture("lines");
    return PixelsBelowTheParent(GetPalette(PaletteName::kDark).running);
  }

  Driver driver_;
  ScriptedRobot* robot_ = nullptr;
};

TEST_F(TreeLines, TheRunningPathLiesOnTheLinesOfItsSiblings) {
  EXPECT_GT(RunningPixelsWith(kMiddle), 4) << "the siblings at rest share its stem";
}

TEST_F(TreeLines, AResultDoesNotHideTheRunningPath) {
  const int before = RunningPixelsWith(kMiddle);
  for (const std::uint16_t beside : {kFirst, kMiddle + 1}) {
    robot_->Set(beside, Status::kFailure);
    driver_.Frames(20);
    EXPECT_GE(PixelsBelowTheParent(GetPalette(PaletteName::kDark).running), before) << beside;
  }
}

TEST_F(TreeLines, EveryColumnAtRestHasItsStem) {
  const Color edge = GetPalette(PaletteName::kDark).edge;
  for (const int first : {1, kLeaves / 2 + 1}) {
    const Box upper = driver_.BoxOf("canvas/Main/1." + std::to_string(first));
    const Box lower = driver_.BoxOf("canvas/Main/1." + std::to_string(first + 1));
    ASSERT_EQ(upper.min.x, lower.min.x);
    const Box left_of_the_gap = {{upper.min.x - 8, upper.max.y - 4},
                                 {upper.min.x - 1, lower.min.y + 2}};
    EXPECT_GT(driver_.CountColor(left_of_the_gap, edge, 60), 3) << "column of leaf " << first;
  }
}

}  // namespace
}  // namespace coppice::editor
