#include "editor/workspace/follow.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(FollowMode, BringsTheRunningNodeIntoViewAndRestsAfterTheUser) {
  Driver driver;
  AddExecuted(driver, "robot:1", 10);
  driver.view().camera.zoom = 3;
  driver.view().camera.offset = {5000, 5000};
  driver.Frames(2);
  driver.Press('F');
  driver.Frames(400);
  EXPECT_TRUE(driver.Has("canvas/Main/1.2.1"));
  driver.view().camera.offset = {5000, 5000};
  driver.Frames(20);
  EXPECT_FALSE(driver.Has("canvas/Main/1.2.1")) << "the user wants to look elsewhere";
  driver.Frames(300);
  EXPECT_TRUE(driver.Has("canvas/Main/1.2.1"));
}

TEST(FollowMode, FindsTheDeepestRunningNode) {
  Driver driver;
  AddExecuted(driver, "robot:1", 10);
  const std::uint32_t node =
      DeepestRunning(*driver.view().scene(), driver.editor.state().workspace.run()->state());
  ASSERT_NE(node, kNoSceneNode);
  EXPECT_EQ(driver.view().scene()->nodes[node].path, "1.2.1");
}

}  // namespace
}  // namespace coppice::editor
