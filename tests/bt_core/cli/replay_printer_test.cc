#include "bt_core/cli/replay_printer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace coppice {
namespace {

using ::testing::HasSubstr;

RecordHeader TwoNodes() {
  RecordHeader header;
  header.start = Time(500);
  header.nodes = {{"a", "A"}, {"b", "B"}};
  header.slots = {{"Main", "key", "int"}};
  return header;
}

TEST(ReplaySummary, CountsWhatGoesBy) {
  const RecordHeader header = TwoNodes();
  ReplaySummary summary(header);
  RecordedTick tick;
  tick.time = Time(900);
  tick.changes = {{0, Status::kIdle, Status::kSuccess}, {1, Status::kIdle, Status::kFailure}};
  tick.writes = {{0, "1"}};
  summary.Add(tick);
  summary.Add(RecordedNote{Time(700), "k", "t"});
  summary.Add(RecordedGap{Time(800), 5, 1, 5, 2, {}});
  EXPECT_EQ(summary.ticks, 1u);
  EXPECT_EQ(summary.changes, 2u);
  EXPECT_EQ(summary.writes, 1u);
  EXPECT_EQ(summary.notes, 1u);
  EXPECT_EQ(summary.nodes[0].successes, 1u);
  EXPECT_EQ(summary.nodes[1].failures, 1u);
  EXPECT_EQ(summary.lost_ticks, 5u);
  EXPECT_EQ(summary.lost_notes, 2u);
  EXPECT_EQ(summary.last - summary.first, Time(400));
  summary.closed = true;
  EXPECT_FALSE(summary.complete());  // there is a gap
}

TEST(ReplayPrinter, NamesGapsAndDamages) {
  const RecordHeader header = TwoNodes();
  std::ostringstream out;
  const auto printer = MakeTextPrinter(out, header);
  printer->Entry(RecordedGap{Time(500), 5, 11, 19, 2, {}});
  printer->Damage({77, "what is wrong"});
  EXPECT_EQ(out.str(),
            "      0.000000  GAP: 5 ticks (11 to 19) and 2 notes are missing\n"
            "DAMAGE at byte 77: what is wrong\n");
}

TEST(ReplayPrinter, ShowsAKeyWithoutValue) {
  const RecordHeader header = TwoNodes();
  std::ostringstream out;
  RecordedTick tick;
  tick.writes = {{0, std::nullopt}};
  MakeTextPrinter(out, header)->Entry(tick);
  EXPECT_THAT(out.str(), HasSubstr("Main{key} = (no value)"));
}

}  // namespace
}  // namespace coppice
