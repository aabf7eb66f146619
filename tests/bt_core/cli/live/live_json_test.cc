#include "bt_core/cli/live/live_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "bt_core/cli/replay/replay_printer.h"
#include "tests/bt_core/cli/described_tree.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

class LiveJsonTest : public ::testing::Test {
 protected:
  // The line that was printed last.
  Json Last() {
    std::string text = out_.str();
    out_.str("");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
    return Json::parse(text);
  }

  std::ostringstream out_;
  LiveJsonPrinter printer_{out_};
};

TEST_F(LiveJsonTest, ATickIsOneLineWithAllThatHappened) {
  printer_.Print(SmallTree());
  EXPECT_EQ(Last()["nodes"], Json({"top", "check", "dock/Drive::3"}));
  printer_.Print(SmallState());
  EXPECT_EQ(Last()["statuses"], Json::object());
  printer_.Print(SmallTick().events());
  EXPECT_EQ(Last(), Json::parse(R"({"type":"tick","time_ns":2000000000,"tick":7,"duration_ns":5000,
    "result":"RUNNING","whole":true,
    "changes":[{"node":"check","from":"IDLE","to":"SUCCESS"},
               {"node":"dock/Drive::3","from":"IDLE","to":"RUNNING"},
               {"node":"top","from":"IDLE","to":"RUNNING"}],
    "writes":[{"scope":"Main","key":"battery","value":0.5,"writer":"check"}],
    "messages":[{"node":"check","kind":"message","text":"all is \"well\""}]})"));
}

TEST_F(LiveJsonTest, KeyframesAreNotPrintedAgain) {
  printer_.Print(SmallTree());
  HistoryState state = SmallState();
  state.cause = HistoryState::Cause::kKeyframe;
  printer_.Print(state);
  out_.str("");
  printer_.Print(state);
  EXPECT_EQ(out_.str(), "");
}

TEST_F(LiveJsonTest, GapsNoticesAndConnectionsHaveATypeEach) {
  HistoryGap gap;
  gap.lost_ticks = 3;
  printer_.Print(gap);
  EXPECT_EQ(Last()["lost_ticks"], 3);
  LiveNotice notice;
  notice.path = "check";
  notice.event.stop.where = DebugStop::Where::kAfter;
  notice.event.stop.result = Status::kFailure;
  printer_.Print(notice);
  EXPECT_EQ(
      Last(),
      Json({{"type", "stopped"}, {"node", "check"}, {"position", "after"}, {"result", "FAILURE"}}));
  LiveConnection connection;
  connection.problem = "no answer";
  printer_.Print(connection);
  EXPECT_EQ(Last(), Json({{"type", "connection"}, {"live", false}, {"problem", "no answer"}}));
  printer_.Print(HistoryNote{Time(Duration(1)), "a", "b\xff"});
  EXPECT_EQ(Last()["kind"], "a");
  printer_.Print(HistoryEnd());
  EXPECT_EQ(Last()["type"], "end");
}

// Two programs, one dialect.
TEST_F(LiveJsonTest, IsThatOfAReplay) {
  const TreeDescription tree = SmallTree();
  const HistoryGap gap{HistoryGap::Cause::kOutput, Time(std::chrono::seconds(3)), 5, 8, 12, 1};
  printer_.Print(tree);
  printer_.Print(SmallState());
  printer_.Print(SmallTick().events());
  printer_.Print(gap);
  printer_.Print(HistoryNote{Time(Duration(4)), "kind", "text"});
  printer_.Print(HistoryEnd{{}, Time(Duration(5)), 7});

  Recording run;
  run.OnTree(tree);
  run.OnState(SmallState());
  run.OnTick(SmallTick().events());
  run.OnGap(gap);
  run.OnNote(HistoryNote{Time(Duration(4)), "kind", "text"});
  run.OnEnd(HistoryEnd{{}, Time(Duration(5)), 7});
  std::ostringstream replayed;
  PrintRun(run, {}, *MakeJsonPrinter(replayed));
  const std::string lines = replayed.str();
  EXPECT_EQ(lines.substr(0, lines.find("{\"type\":\"summary\"")), out_.str());
}

}  // namespace
}  // namespace coppice
