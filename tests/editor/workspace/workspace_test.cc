#include "editor/workspace/workspace.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Workspace, ShowsTheNewTreeWhenARobotSwapsIt) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  EXPECT_TRUE(driver.Has("canvas/Main/1"));
  robot->SetTree(R"(<root><BehaviorTree ID="Other" _fullpath=""><Sequence )"
                 R"(_uid="1"/></BehaviorTree></root>)");
  driver.Frames();
  EXPECT_TRUE(driver.Has("canvas/Other/1"));
  EXPECT_FALSE(driver.Has("canvas/Main/1"));
}

TEST(Workspace, ShowsAnotherRunWhenTheShownOneIsClosed) {
  Driver driver;
  driver.AddRobot("one:1", kLiveTree);
  driver.AddRobot("two:2", kLiveTree);
  Workspace& workspace = driver.editor.state().workspace;
  workspace.CloseRun(1, 0);
  driver.Frames();
  ASSERT_NE(workspace.run(), nullptr);
  EXPECT_EQ(workspace.run()->name(), "one:1");
  EXPECT_TRUE(driver.Has("canvas/Main/1"));
  workspace.CloseRun(0, 0);
  driver.Frames();
  EXPECT_EQ(workspace.run(), nullptr);
  EXPECT_EQ(workspace.view(), nullptr);
}

TEST(Workspace, ReportsAMissingFileOfModels) {
  Driver driver;
  driver.editor.AddModels("/nowhere/models.xml");
  EXPECT_EQ(driver.editor.state().workspace.model_problems().size(), 1U);
}

TEST(Workspace, KnowsTheModelsOfAFileInEveryTree) {
  const TemporaryFile models(
      "models.xml", R"(<root><TreeNodesModel><Condition ID="Step"/></TreeNodesModel></root>)");
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.AddModels(models.path());
  driver.editor.Open(file.path());
  const Scene& scene = *driver.view().scene();
  EXPECT_EQ(scene.nodes[scene.FindPath("1.2.1.1")].shape, Shape::kCondition);
}

TEST(Workspace, KeepsCameraAndCollapsedNodesOfEachTree) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Click("canvas/MainTree/1.2/toggle");
  ASSERT_TRUE(driver.Click("project/small.xml/Walk"));
  EXPECT_TRUE(driver.Has("canvas/Walk/1.1"));
  ASSERT_TRUE(driver.Click("project/small.xml/MainTree"));
  EXPECT_FALSE(driver.Has("canvas/MainTree/1.2.1"));
}

}  // namespace
}  // namespace coppice::editor
