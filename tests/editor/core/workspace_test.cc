#include "editor/core/workspace.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Workspace, ShowsTheNewTreeWhenARobotSwapsIt) {
  Driver driver;
  const auto robot = driver.AddRobot("robot:1", kLiveTree);
  EXPECT_TRUE(driver.Has("canvas/Main/1"));
  auto tree = std::make_shared<LiveTree>();
  tree->forest = Forest::FromRobot(
      "<root><BehaviorTree ID=\"Other\" _fullpath=\"\"><Sequence "
      "_uid=\"1\"/></BehaviorTree></root>",
      "robot:1", tree->problems);
  robot->tree = tree;
  driver.Frames();
  EXPECT_TRUE(driver.Has("canvas/Other/1"));
  EXPECT_FALSE(driver.Has("canvas/Main/1"));
}

TEST(Workspace, AsksARobotForTheBoardsOfItsTree) {
  Workspace workspace([](const Scene& scene) {
    return std::vector<Point>(scene.nodes.size(), Point{10, 10});
  });
  std::shared_ptr<LiveSnapshot> snapshot;
  auto source = std::make_unique<ScriptedRobot>("robot:1", &snapshot);
  const ScriptedRobot& robot = *source;
  workspace.AddRobot(std::move(source));
  workspace.Update(0);
  EXPECT_TRUE(robot.watched.empty());
  auto tree = std::make_shared<LiveTree>();
  tree->forest = Forest::FromRobot(kLiveTree, "robot:1", tree->problems);
  snapshot->tree = tree;
  workspace.Update(0.1);
  EXPECT_EQ(robot.watched, (std::vector<std::string>{"Main", "walk"}));
}

TEST(Workspace, StampsBlackboardValuesThatChange) {
  Driver driver;
  const auto robot = driver.AddRobot("robot:1", kLiveTree);
  robot->boards = {{"Main", {{"goal", "1"}, {"level", "5"}}}};
  driver.Frames(1);
  robot->boards = {{"Main", {{"goal", "2"}, {"level", "5"}}}};
  driver.Frames(1);
  const BoardHistory& boards = driver.editor.state().workspace.robot()->boards;
  EXPECT_GT(boards.at("Main").at("goal").changed_at, 0);
  EXPECT_LT(boards.at("Main").at("level").changed_at, 0);
}

TEST(Workspace, ReportsAMissingFileOfModels) {
  Driver driver;
  driver.editor.AddModels("/nowhere/models.xml");
  EXPECT_EQ(driver.editor.state().workspace.model_problems().size(), 1U);
}

TEST(Workspace, KnowsTheModelsOfAFileInEveryTree) {
  const TemporaryFile models(
      "models.xml", "<root><TreeNodesModel><Condition ID=\"Step\"/></TreeNodesModel></root>");
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
