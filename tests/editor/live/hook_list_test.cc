#include "editor/live/hook_list.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

Hook Breakpoint(const std::string& path) {
  Hook hook;
  hook.path = path;
  return hook;
}

Hook Fault(const std::string& path) {
  Hook hook;
  hook.path = path;
  hook.action = HookAction::kReplace;
  hook.status = Status::kFailure;
  return hook;
}

TEST(HookListTest, TellsBreakpointsAndFaultsApart) {
  HookList hooks;
  hooks.Add("", Breakpoint("a"));
  EXPECT_FALSE(hooks.has_faults());
  hooks.Add("robot:1", Fault("a"));
  EXPECT_TRUE(hooks.has_faults());
  EXPECT_EQ(hooks.FindAt("robot:1", "a", false)->number, 2U);
  EXPECT_EQ(hooks.FindAt("other:1", "a", false), nullptr);
  EXPECT_EQ(hooks.FindAt("other:1", "a", true)->number, 1U) << "it is meant for every robot";
  hooks.RemoveFaults();
  EXPECT_FALSE(hooks.has_faults());
  EXPECT_EQ(hooks.all().size(), 1U);
}

TEST(HookListTest, AChangedHookIsAnotherOne) {
  HookList hooks;
  hooks.Add("", Breakpoint("a"));
  hooks.Change(1, Breakpoint("b"));
  EXPECT_EQ(hooks.Find(1), nullptr);
  ASSERT_EQ(hooks.all().size(), 1U);
  EXPECT_EQ(hooks.all()[0].number, 2U);
  EXPECT_EQ(hooks.all()[0].hook.path, "b");
  hooks.Remove(2);
  EXPECT_TRUE(hooks.all().empty());
}

TEST(HookListTest, WritesAHookForPeople) {
  Hook hook = Breakpoint("a");
  EXPECT_EQ(ToString(hook), "before");
  hook.position = HookPosition::kAfter;
  hook.condition = "battery < 20";
  hook.from_hit = 3;
  EXPECT_EQ(ToString(hook), "after, if battery < 20, from hit 3 on");
  hook = Fault("a");
  hook.times = 2;
  EXPECT_EQ(ToString(hook), "FAILURE x2");
  hook = Hook();
  hook.action = HookAction::kDelay;
  hook.delay = std::chrono::milliseconds(500);
  EXPECT_EQ(ToString(hook), "delay 0.5 s");
}

}  // namespace
}  // namespace coppice::editor
