#include "bt_core/engine/tree_state.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using Names = std::vector<std::string>;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;

LeafScript Results(std::map<std::string, std::vector<Status>> results) {
  LeafScript script;
  script.results = std::move(results);
  return script;
}

TEST(TreeState, BringsBackStatusesAndMemory) {
  Stage stage(Main("<Repeat num_cycles=\"3\"><Sequence><AlwaysSuccess/><Leaf name=\"a\"/>"
                   "</Sequence></Repeat>"),
              Results({{"a", {kRunning, kSuccess, kRunning, kRunning}}}));
  stage.executor->Tick();
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  EXPECT_NE(stage.executor->Save().memory, state.memory);
  stage.executor->Restore(state);
  EXPECT_EQ(stage.executor->Save().memory, state.memory);
}

TEST(TreeState, BringsBackTheBlackboard) {
  Stage stage(Main("<Drive goal=\"2\" total=\"{total}\" distance=\"{way}\"/>"));
  stage.executor->Tick();
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  stage.executor->Restore(state);
  stage.executor->Tick();
  const SlotIndex total = stage.program->layout.Find(0, "total");
  EXPECT_EQ(stage.executor->blackboard()[total].value.Get<int>(), 6);
}

TEST(TreeState, HaltsWhatDidNotRunThen) {
  Stage stage(Main("<Leaf name=\"a\"/>"), Results({{"a", {kRunning}}}));
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor->Restore(state);
  EXPECT_EQ(stage.TakeEvents(), (Names{"halt a"}));
}

TEST(TreeState, StartsWhatRanThenInTheNextTick) {
  Stage stage(Main("<Sequence><Leaf name=\"a\"/><Leaf name=\"b\"/></Sequence>"),
              Results({{"a", {kSuccess}}, {"b", {kRunning, kSuccess, kRunning}}}));
  stage.executor->Tick();
  const TreeState state = stage.executor->Save();
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  stage.TakeEvents();
  stage.executor->Restore(state);
  EXPECT_EQ(stage.executor->statuses()[0], kRunning);
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.TakeEvents(), (Names{"start b"}));
}

TEST(TreeState, SinksAreToldOfARestore) {
  struct Watch : TickSink {
    void OnTick(const TickEvents&) override {}
    void OnJump(const Executor& executor) override { statuses = executor.statuses(); }
    std::vector<Status> statuses;
  } watch;
  Stage stage(Main("<Leaf name=\"a\"/>"), Results({{"a", {kSuccess}}}));
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  stage.executor->AddSink(&watch);
  stage.executor->Restore(state);
  stage.executor->RemoveSink(&watch);
  EXPECT_EQ(watch.statuses, std::vector<Status>{Status::kIdle});
}

TEST(TreeState, OfAnotherTreeIsRefused) {
  Stage stage(Main("<Leaf name=\"a\"/>"));
  Stage other(Main("<Inverter><Leaf name=\"a\"/></Inverter>"));
  EXPECT_THROW(stage.executor->Restore(other.executor->Save()), std::invalid_argument);
}

}  // namespace
}  // namespace coppice
