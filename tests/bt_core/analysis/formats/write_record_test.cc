#include "bt_core/analysis/formats/write_record.h"

#include <gtest/gtest.h>

#include "bt_core/analysis/load_recording.h"
#include "tests/bt_core/analysis/recorded_run.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

constexpr char kTree[] =
    "<BehaviorTree ID='Main'><Repeat num_cycles='-1'><Sequence><Script code='n := 1.5'/>"
    "<Sleep name='sleep' msec='250'/></Sequence></Repeat></BehaviorTree>";

class WriteRecordTest : public testing::Test {
 protected:
  std::optional<Recording> Again(const std::string& bytes) {
    WriteFile(folder_.Path("run.coppice"), bytes);
    return LoadRecording(folder_.Path("run.coppice"), diagnostics_);
  }
  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(WriteRecordTest, GapsNotesAndTheEndStandWhereTheyStood) {
  RecordedRun run(kTree);
  Recording& recording = run.keeper.run;
  for (int i = 0; i < 3; ++i) run.Tick();
  recording.OnNote({run.clock.Now(), "operator", "look here"});
  run.Tick();
  HistoryGap gap;
  gap.cause = HistoryGap::Cause::kOutput;
  gap.lost_ticks = 7;
  gap.first_tick = 5;
  gap.last_tick = 11;
  recording.OnGap(gap);
  run.keeper.Lose();
  run.Tick();
  recording.OnEnd({HistoryEnd::Cause::kClosed, run.clock.Now(), 5});
  const auto again = Again(ToRecord(recording));
  ASSERT_TRUE(again) << diagnostics_.ToString();
  EXPECT_EQ(diagnostics_.ToString(), "");
  ASSERT_EQ(again->notes().size(), 1U);
  EXPECT_EQ(again->notes()[0].tick, recording.notes()[0].tick);
  EXPECT_EQ(again->notes()[0].note.text, "look here");
  ASSERT_EQ(again->gaps().size(), 1U);
  EXPECT_EQ(again->gaps()[0].tick, recording.gaps()[0].tick);
  EXPECT_EQ(again->gaps()[0].gap.lost_ticks, 7U);
  EXPECT_EQ(again->sections().size(), recording.sections().size());
  EXPECT_TRUE(again->is_closed());
  EXPECT_EQ(again->ticks().size(), recording.ticks().size());
}

TEST_F(WriteRecordTest, EveryTickOfALongRunHasItsStateAndItsBytes) {
  RecordedRun run(kTree);
  for (int i = 0; i < 20000; ++i) run.Tick();
  const Recording& recording = run.keeper.run;
  const auto again = Again(ToRecord(recording));
  ASSERT_TRUE(again) << diagnostics_.ToString();
  ASSERT_EQ(again->ticks().size(), 20000U);
  for (std::size_t i = 0; i < 20000; i += 997) {
    EXPECT_EQ(again->Before(i).statuses, recording.Before(i).statuses) << i;
    EXPECT_EQ(again->Before(i).values, recording.Before(i).values) << i;
    const EventWords words = again->EventsOf(i).words;
    const EventWords expected = recording.EventsOf(i).words;
    ASSERT_EQ(words.size, expected.size) << i;
    EXPECT_TRUE(std::equal(words.data, words.data + words.size, expected.data)) << i;
  }
}

TEST_F(WriteRecordTest, WhatIsDamagedOnTheDiskIsLeftOutWithAWarning) {
  RecordedRun run(kTree);
  for (int i = 0; i < 2000; ++i) run.Tick();
  std::string bytes = ToRecord(run.keeper.run);
  bytes[bytes.size() - 20] ^= 1;
  const auto again = Again(bytes);
  ASSERT_TRUE(again) << diagnostics_.ToString();
  EXPECT_FALSE(diagnostics_.has_errors());
  EXPECT_EQ(again->damages(), 1U);
  EXPECT_NE(diagnostics_.ToString().find("damaged at byte "), std::string::npos);
  EXPECT_LT(again->ticks().size(), 2000U);
}

TEST_F(WriteRecordTest, WhatIsNoRecordIsAnError) {
  EXPECT_FALSE(Again("no record"));
  EXPECT_TRUE(diagnostics_.has_errors());
}

}  // namespace
}  // namespace coppice
