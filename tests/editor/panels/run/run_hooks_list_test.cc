#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunHooksList, SwitchesAndRemovesBreakpoints) {
  Driver driver;
  ExecutedSource* robot = AddExecuted(driver, "robot:1", 10);
  ASSERT_TRUE(driver.Click("canvas/Main/1.2.1"));
  driver.Press(kKeyF1 + 8);
  const HookList& hooks = driver.editor.state().workspace.hooks;
  ASSERT_EQ(hooks.all().size(), 1U);
  EXPECT_EQ(hooks.all()[0].hook.path, "pass/Drive");
  EXPECT_EQ(robot->commands.back().kind, LiveCommand::Kind::kAddHook);
  ASSERT_TRUE(driver.Click("run/hook/1/on"));
  EXPECT_FALSE(hooks.all()[0].hook.enabled);
  EXPECT_EQ(robot->commands.back().kind, LiveCommand::Kind::kRemoveHook);
  driver.Picture("hooks");
  ASSERT_TRUE(driver.Click("run/hook/2/remove"));
  EXPECT_TRUE(hooks.all().empty());
}

TEST(RunHooksList, RemovesWhatAnotherProgramHasLeft) {
  Driver driver;
  ExecutedSource* robot = AddExecuted(driver, "robot:1", 10);
  ForeignHook foreign;
  foreign.id = HookId{7};
  foreign.hook.path = "pass/Drive";
  robot->TellForeignHooks({foreign});
  driver.editor.state().run.tab = RunTab::kHooks;
  driver.Frames();
  driver.Picture("foreign_hooks");
  ASSERT_TRUE(driver.Click("run/foreign/7/remove"));
  EXPECT_EQ(robot->commands.back().kind, LiveCommand::Kind::kRemoveHook);
  EXPECT_EQ(robot->commands.back().id, 7U);
}

TEST(RunHooksList, AsksForTheConditionAndTheHitCount) {
  Driver driver;
  AddExecuted(driver, "robot:1", 10);
  ASSERT_TRUE(driver.Click("canvas/Main/1.2.1"));
  driver.Press(kKeyF1 + 8);
  ASSERT_TRUE(driver.Click("run/hook/1/condition"));
  driver.Type("steps > 3 #2");
  driver.Press(kKeyEnter);
  const Hook& hook = driver.editor.state().workspace.hooks.all()[0].hook;
  EXPECT_EQ(hook.condition, "steps > 3");
  EXPECT_EQ(hook.from_hit, 2U);
}

}  // namespace
}  // namespace coppice::editor
