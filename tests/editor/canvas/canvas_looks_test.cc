#include "editor/canvas/canvas_looks.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

class CanvasLooksTest : public testing::Test {
 protected:
  CanvasLooksTest() {
    auto scene = std::make_shared<Scene>(*kept_);
    for (std::uint32_t i = 0; i < scene->nodes.size(); ++i) {
      scene->nodes[i].run_node = NodeIndex(i);
    }
    view_.SetScene(scene, SameSize, 0);
    state_.states.resize(scene->nodes.size());
  }
  NodeLook Look(std::uint32_t k) const { return LookOf(view_, options_, k, {{0, 0}, {9, 9}}, 1); }

  const std::shared_ptr<const Scene> kept_ = MakeScene("<A><B><C/><D/></B><E/></A>");
  TreeView view_;
  TreeSnapshot state_;
  CanvasOptions options_;
};

TEST_F(CanvasLooksTest, ACollapsedNodeTellsWhatRunsAndWhatIsWrongBelowIt) {
  state_.states[3].status = Status::kRunning;
  const std::vector<Badge> badges = {Badge::kNone, Badge::kNone, Badge::kError, Badge::kNone};
  const std::vector<Change> changes = {Change::kNone, Change::kNone, Change::kAdded};
  options_.live = &state_;
  options_.badges = &badges;
  options_.changes = &changes;
  EXPECT_EQ(Look(1).hidden, 0U);
  EXPECT_EQ(Look(1).hidden_badge, Badge::kNone);
  view_.SetCollapsed(1, true, 0);
  const NodeLook look = Look(1);
  EXPECT_EQ(look.hidden, 2U);
  EXPECT_EQ(look.hidden_status, Status::kRunning);
  EXPECT_EQ(look.hidden_badge, Badge::kError);
  EXPECT_EQ(look.change, Change::kChanged) << "something in it";
}

TEST_F(CanvasLooksTest, WithoutARobotNothingHasAStatus) {
  EXPECT_EQ(StateOf(nullptr, view_.scene()->nodes[0]).status, Status::kIdle);
  EXPECT_FALSE(Look(0).offline);
  state_.is_fresh = false;
  options_.live = &state_;
  EXPECT_TRUE(Look(0).offline);
}

TEST_F(CanvasLooksTest, BadgesOfAnotherVersionOfTheTreeAreLeftOut) {
  const std::vector<Badge> too_few = {Badge::kError};
  options_.badges = &too_few;
  EXPECT_EQ(BadgeOf(options_, 0), Badge::kError);
  EXPECT_EQ(BadgeOf(options_, 4), Badge::kNone);
}

}  // namespace
}  // namespace coppice::editor
