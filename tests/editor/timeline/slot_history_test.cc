#include "editor/timeline/slot_history.h"

#include <gtest/gtest.h>

#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {
namespace {

TEST(SlotHistoryTest, KnowsWhoWroteWhatAndWhen) {
  ExecutedTree robot(R"(<BehaviorTree ID="Main"><Do as="work" count="{count}"/></BehaviorTree>)");
  coppice::editor::Run run;
  Follow follow(robot.executor, run);
  for (int i = 0; i < 5; ++i) robot.Tick();
  robot.executor.Writer<int>("count").Send(40);
  robot.results["work"] = Status::kRunning;
  robot.Tick();
  const auto& slots = run.TracksAt(0).tree()->slots;
  SlotIndex slot{0};
  while (slots[slot].name != "count") ++slot;
  const auto& writes = run.TracksAt(0).WritesOf(slot);
  ASSERT_EQ(writes.size(), 7U);
  EXPECT_EQ(WritesUpTo(writes, 2), 3U);
  EXPECT_EQ(WriterOf(run, writes[2]), "Do::1");
  EXPECT_EQ(ValueOf(run, writes[2]), "3");
  EXPECT_EQ(WriterOf(run, writes[5]), "from outside");
  EXPECT_EQ(ValueOf(run, writes[5]), "40");
  const auto samples = SampleSlot(run, slot, {0, 3, 5});
  EXPECT_EQ(samples, (std::vector<std::optional<double>>{1, 4, 6}));
}

TEST(SlotHistoryTest, ReadsNumbersAndTruths) {
  std::string bytes;
  AppendValueBytes(Value(true), bytes);
  EXPECT_EQ(NumberOf(bytes), 1);
  bytes.clear();
  AppendValueBytes(Value(2.5), bytes);
  EXPECT_EQ(NumberOf(bytes), 2.5);
  bytes.clear();
  AppendValueBytes(Value(std::string("word")), bytes);
  EXPECT_EQ(NumberOf(bytes), std::nullopt);
  EXPECT_EQ(NumberOf(""), std::nullopt);
}

TEST(SlotHistory, WhatAKeyHoldsAfterARestartOfTheProgramNobodyHasWritten) {
  ExecutedTree robot(R"(<BehaviorTree ID="Main"><Do as="work" count="{count}"/></BehaviorTree>)");
  coppice::editor::Run run;
  const Follow follow(robot.executor, run);
  robot.Tick();
  SlotIndex slot{0};
  while (run.TracksAt(0).tree()->slots[slot].name != "count") ++slot;
  EXPECT_NE(LastWriteOf(run, slot, 0), nullptr);
  TreeDescription again = *run.TracksAt(0).tree();
  again.info.run[0] = static_cast<RunId::value_type>(again.info.run[0] + 1);
  run.OnTree(again);
  run.OnState(run.now().State(HistoryState::Cause::kBegin));
  run.OnTick({1, Time{}, Duration(0), Status::kSuccess, true, {}});
  EXPECT_EQ(LastWriteOf(run, slot, 1), nullptr);
  EXPECT_NE(LastWriteOf(run, slot, 0), nullptr) << "before it as it was";
}

}  // namespace
}  // namespace coppice::editor
