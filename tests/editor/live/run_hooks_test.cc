#include "editor/live/run_hooks.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using Kind = LiveCommand::Kind;

class RunHooksTest : public testing::Test {
 protected:
  class Ignore : public LiveListener {
    void OnTree(const TreeDescription&) override {}
    void OnState(const HistoryState&) override {}
    void OnTick(const TickEvents&) override {}
  };

  void Sync() {
    hooks_.Sync(wanted_);
    Ignore ignore;
    robot_.Pump(ignore);
  }
  static Hook At(const std::string& path) {
    Hook hook;
    hook.path = path;
    return hook;
  }

  ScriptedRobot robot_{"robot:1", kLiveTree};
  RunHooks hooks_{robot_};
  HookList wanted_;
};

TEST_F(RunHooksTest, SetsWhatIsWantedOnceAndRemovesItWhenItIsWantedNoMore) {
  wanted_.Add("", At("walk/Step::5"));
  wanted_.Add("other:1", At("Say"));
  Sync();
  Sync();
  ASSERT_EQ(robot_.commands.size(), 1U) << "the other robot's is not for this one";
  EXPECT_EQ(robot_.commands[0].kind, Kind::kAddHook);
  EXPECT_EQ(robot_.commands[0].hook.path, "walk/Step::5");
  EXPECT_EQ(hooks_.Find(1)->id, 1U);
  wanted_.Remove(1);
  Sync();
  ASSERT_EQ(robot_.commands.size(), 2U);
  EXPECT_EQ(robot_.commands[1].kind, Kind::kRemoveHook);
  EXPECT_EQ(robot_.commands[1].id, 1U);
  EXPECT_EQ(hooks_.Find(1), nullptr);
}

TEST_F(RunHooksTest, AHookThatIsSwitchedOffIsRemovedAndComesBack) {
  wanted_.Add("", At("Say"));
  Sync();
  Hook hook = At("Say");
  hook.enabled = false;
  wanted_.Change(1, hook);
  Sync();
  EXPECT_EQ(robot_.commands.back().kind, Kind::kRemoveHook);
  hook.enabled = true;
  wanted_.Change(2, hook);
  Sync();
  EXPECT_EQ(robot_.commands.back().kind, Kind::kAddHook);
}

TEST_F(RunHooksTest, SetsAllAgainAfterAReconnection) {
  wanted_.Add("", At("Say"));
  Sync();
  hooks_.Forget();
  Sync();
  EXPECT_EQ(robot_.commands.size(), 2U);
}

TEST_F(RunHooksTest, CountsHowOftenAHookActed) {
  wanted_.Add("", At("Say"));
  Sync();
  LiveNotice notice;
  notice.event.kind = DebugEvent::Kind::kStopped;
  notice.event.stop.hook = hooks_.Find(1)->id;
  hooks_.OnNotice(notice);
  hooks_.OnNotice(notice);
  EXPECT_EQ(hooks_.Find(1)->hits, 2U);
  EXPECT_EQ(hooks_.NumberOf(notice.event.stop.hook), 1U);
  EXPECT_EQ(hooks_.NumberOf(HookId{77}), 0U);
}

}  // namespace
}  // namespace coppice::editor
