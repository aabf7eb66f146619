#include "editor/panels/outline_drop.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/canvas/make_scene.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(OutlineTarget, TheEdgesOfARowMeanItsSiblingsAndTheMiddleTheNode) {
  const auto scene = MakeScene("<A><B/><C/></A>");
  const std::uint32_t c = scene->FindPath("1.2");
  EXPECT_EQ(OutlineTarget(*scene, c, 0.1F), (DropTarget{DropPlace::kGap, 0, 1, {}}));
  EXPECT_EQ(OutlineTarget(*scene, c, 0.9F), (DropTarget{DropPlace::kGap, 0, 2, {}}));
  EXPECT_EQ(OutlineTarget(*scene, c, 0.5F), (DropTarget{DropPlace::kNode, c, 0, {}}));
  EXPECT_EQ(OutlineTarget(*scene, 0, 0.1F), (DropTarget{DropPlace::kNode, 0, 0, {}}))
      << "the root has no siblings";
}

class OutlineDropTest : public testing::Test {
 protected:
  OutlineDropTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
  }
  std::string Order() {
    std::string order;
    for (const SceneNode& node : driver_.view().scene()->nodes) {
      if (std::count(node.path.begin(), node.path.end(), '.') == 1) {
        order += std::string(node.name) + " ";
      }
    }
    return order;
  }
  Point Row(const std::string& path, float part) const {
    const Box box = driver_.BoxOf("outline/" + path);
    return {box.center().x, box.min.y + part * box.height()};
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(OutlineDropTest, ARowIsDraggedAmongItsSiblings) {
  ASSERT_EQ(Order(), "Fallback walk AlwaysSuccess ");
  driver_.Drag(Row("1.3", 0.5F), Row("1.1", 0.1F));
  driver_.Frames();
  EXPECT_EQ(Order(), "AlwaysSuccess Fallback walk ");
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Order(), "Fallback walk AlwaysSuccess ");
}

TEST_F(OutlineDropTest, ATypeIsDroppedIntoANode) {
  const Box type = driver_.BoxOf("types/Fallback");
  driver_.Drag(type.center(), Row("1.1", 0.5F));
  driver_.Frames();
  EXPECT_EQ(driver_.Selected(), "1.1.3");
}

TEST_F(OutlineDropTest, WhatIsNotPossibleChangesNothing) {
  driver_.Drag(Row("1.1", 0.5F), Row("1.1.2", 0.5F));
  driver_.Frames();
  EXPECT_EQ(driver_.editor.state().workspace.project().Find(file_.path())->text, kSmallFile);
}

TEST(EmptyTreeDrop, ATypeBecomesTheRootOfAnEmptyTree) {
  Driver driver;
  driver.Frames();
  driver.Press('N', kCtrl);
  driver.Frames();
  const Box type = driver.BoxOf("types/Fallback");
  ASSERT_GT(type.width(), 0);
  driver.Drag(type.center(), driver.BoxOf("canvas").center());
  driver.Frames();
  ASSERT_NE(driver.editor.state().workspace.view(), nullptr);
  EXPECT_EQ(driver.Selected(), "1");
}

}  // namespace
}  // namespace coppice::editor
