// The JSON that `coppice replay` writes, read by a library.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "bt_core/cli/replay/replay_printer.h"

namespace coppice {
namespace {

using nlohmann::json;

TEST(ReplayJson, WritesOneObjectPerLine) {
  TreeDescription tree;
  tree.main_tree = "Main";
  tree.nodes.resize(1);
  tree.nodes[0].path = "a";
  std::ostringstream out;
  const auto printer = MakeJsonPrinter(out, std::chrono::seconds(1));
  printer->Tree(tree);
  PrintedTick tick{7, std::chrono::milliseconds(2500), Duration(1000), Status::kRunning, {}, {},
                   {}};
  tick.changes = {{"a", Status::kIdle, Status::kRunning}};
  tick.writes = {{"Main", "key", std::string("\x01text"), "a"}, {"Main", "key", "", ""}};
  tick.messages = {{"a", R"(says "so")"}};
  printer->Tick(tick);
  printer->Gap({HistoryGap::Cause::kOutput, std::chrono::seconds(3), 5, 8, 12, 1});
  std::istringstream lines(out.str());
  std::string line;
  std::vector<json> objects;
  while (std::getline(lines, line)) objects.push_back(json::parse(line));
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[0]["nodes"], json({"a"}));
  EXPECT_EQ(objects[1]["time"], 1.5);
  EXPECT_EQ(objects[1]["changes"][0]["to"], "RUNNING");
  EXPECT_EQ(objects[1]["writes"][0]["value"], "text");
  EXPECT_TRUE(objects[1]["writes"][1]["value"].is_null());
  EXPECT_EQ(objects[1]["messages"][0]["text"], R"(says "so")");
  EXPECT_EQ(objects[2]["lost_ticks"], 5);
}

}  // namespace
}  // namespace coppice
