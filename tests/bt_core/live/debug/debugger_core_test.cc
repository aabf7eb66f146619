#include "bt_core/live/debug/debugger_core.h"

#include <gtest/gtest.h>

#include "tests/bt_core/counting_new.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

TEST(DebuggerCore, CostsNothingWhileNothingIsSet) {
  Stage stage(Main("<Sequence><AlwaysSuccess/><AlwaysSuccess/></Sequence>"));
  const Debugger debugger(*stage.executor);
  stage.executor->Tick();
  const std::uint64_t before = Allocations();
  for (int i = 0; i < 100; ++i) stage.executor->Tick();
  EXPECT_EQ(Allocations(), before);
}

TEST(DebuggerCore, TakesTheHooksFromTheExecutorWhenTheDebuggerIsGone) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/></Sequence>)"));
  {
    Debugger debugger(*stage.executor);
    Hook hook;
    hook.node = NodeIndex{1};
    hook.action = HookAction::kReplace;
    hook.status = Status::kFailure;
    EXPECT_TRUE(debugger.Add(hook));
    EXPECT_EQ(stage.executor->Tick(), Status::kFailure);
  }
  EXPECT_EQ(stage.executor->Tick(), Status::kSuccess);
  EXPECT_EQ(stage.executor->Tick(), Status::kSuccess);
}

}  // namespace
}  // namespace coppice
