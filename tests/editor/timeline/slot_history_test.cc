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

}  // namespace
}  // namespace coppice::editor
