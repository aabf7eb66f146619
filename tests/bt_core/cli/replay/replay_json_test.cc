// The JSON that `coppice replay` writes, read by a library.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "bt_core/cli/replay/replay_printer.h"
#include "tests/bt_core/cli/described_tree.h"

namespace coppice {
namespace {

using nlohmann::json;

TEST(ReplayJson, WritesOneObjectPerLine) {
  TreeDescription tree;
  tree.main_tree = "Main";
  tree.nodes.resize(1);
  tree.nodes[0].path = "a";
  std::ostringstream out;
  const auto printer = MakeJsonPrinter(out);
  printer->Tree(tree);
  ToldTick tick{
      7, Time(std::chrono::milliseconds(2500)), Duration(1000), Status::kRunning, true, {}, {}, {}};
  tick.changes = {{"a", Status::kIdle, Status::kRunning}};
  tick.writes = {{"Main", "key", std::string("\x01text"), "a"}, {"Main", "key", "", ""}};
  tick.messages = {{"a", EventText::kMessage, R"(says "so")"}};
  printer->Tick(tick);
  printer->Gap({HistoryGap::Cause::kOutput, Time(std::chrono::seconds(3)), 5, 8, 12, 1});
  std::istringstream lines(out.str());
  std::string line;
  std::vector<json> objects;
  while (std::getline(lines, line)) objects.push_back(json::parse(line));
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[0]["nodes"], json({"a"}));
  EXPECT_EQ(objects[1]["time_ns"], 2'500'000'000);
  EXPECT_EQ(objects[1]["changes"][0]["to"], "RUNNING");
  EXPECT_EQ(objects[1]["writes"][0]["value"], "text");
  EXPECT_EQ(objects[1]["writes"][0]["writer"], "a");
  EXPECT_TRUE(objects[1]["writes"][1]["value"].is_null());
  EXPECT_EQ(objects[1]["messages"][0]["text"], R"(says "so")");
  EXPECT_EQ(objects[2]["lost_ticks"], 5);
}

TEST(ReplayJson, TellsWhatIsNoMessageOfTheNode) {
  EventWriter words;
  words.Text(NodeIndex{1}, EventText::kException, "no way");
  words.Text(NodeIndex{1}, EventText::kInjected,
             std::string(1, static_cast<char>(Status::kFailure)));
  const TreeDescription tree = SmallTree();
  HistoryFollower follower(ShapeOf(tree), SmallState());
  const json tick = json::parse(EventJson(
      TellTick(tree, follower, {1, Time{}, Duration(0), Status::kFailure, true, words.words()})));
  EXPECT_EQ(tick["messages"][0],
            json({{"node", "check"}, {"kind", "exception"}, {"text", "no way"}}));
  EXPECT_EQ(tick["messages"][1],
            json({{"node", "check"}, {"kind", "injected"}, {"text", "FAILURE"}}));
}

}  // namespace
}  // namespace coppice
