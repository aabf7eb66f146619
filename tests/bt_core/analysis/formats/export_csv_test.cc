// Runs as comma separated values (RFC 4180).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/analysis/formats/export.h"
#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

TEST(ExportCsv, TextsWithCommasQuotesAndLinesAreQuoted) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence name='a,&quot;b&quot;'>"
      R"(<Script name='s' code="text := 'x,y'"/><Sleep name='z' msec='500'/></Sequence>)"
      "</BehaviorTree>");
  run.Tick();
  const std::string csv = ToCsv(run.keeper.run);
  EXPECT_THAT(csv, HasSubstr("0.000000000,1,write,Main{text},,\"x,y\",s\r\n"));
  EXPECT_THAT(csv, HasSubstr(",1,change,\"a,\"\"b\"\"\",IDLE,RUNNING,\r\n"));
}

TEST(ExportCsv, ExceptionsAndDeliveriesAreTold) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><ScriptCondition name='c' code='battery &lt; nobody'/>"
      "</BehaviorTree>");
  run.executor.Writer<double>("battery").Send(0.5);
  run.Tick();
  const std::string csv = ToCsv(run.keeper.run);
  EXPECT_THAT(csv, HasSubstr(",1,delivery,Main{battery},,0.5,\r\n"));
  EXPECT_THAT(csv, HasSubstr(",1,exception,c,,"));
  EXPECT_THAT(csv, HasSubstr(",1,change,c,IDLE,FAILURE,\r\n"));
}

TEST(ExportCsv, GapsAndNotesStandWhereTheyHappened) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sleep name='z' msec='5000' _onSuccess='x := 2'/></BehaviorTree>");
  run.Tick();
  Recording& recording = run.keeper.run;
  recording.OnNote({run.clock.Now() - std::chrono::milliseconds(50), "operator", "doors, shut"});
  HistoryGap gap;
  gap.time = run.clock.Now();
  gap.lost_ticks = 3;
  gap.first_tick = 2;
  gap.last_tick = 4;
  recording.OnGap(gap);
  run.keeper.Lose();
  run.executor.Writer<double>("x").Send(1);
  run.Tick();
  const std::string csv = ToCsv(recording);
  const std::size_t begun = csv.find("change,z,IDLE,RUNNING");
  const std::size_t note = csv.find("0.050000000,0,note,operator,,\"doors, shut\",\r\n");
  const std::size_t lost = csv.find("0.100000000,4,gap,,,3 ticks,\r\n");
  const std::size_t next = csv.find("delivery,Main{x}");
  ASSERT_NE(begun, std::string::npos) << csv;
  ASSERT_NE(note, std::string::npos) << csv;
  ASSERT_NE(lost, std::string::npos) << csv;
  ASSERT_NE(next, std::string::npos) << csv;
  EXPECT_LT(begun, note);
  EXPECT_LT(note, lost);
  EXPECT_LT(lost, next);
}

TEST(ExportCsv, WhatIsBehindTheLastTickIsNotForgotten) {
  RecordedRun run("<BehaviorTree ID='Main'><AlwaysSuccess name='a'/></BehaviorTree>");
  run.Tick();
  run.keeper.run.OnNote({run.clock.Now(), "end", "good night"});
  EXPECT_THAT(ToCsv(run.keeper.run), HasSubstr("note,end,,good night,\r\n"));
}

}  // namespace
}  // namespace coppice
