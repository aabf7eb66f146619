// The JSON that `coppice replay` writes by hand, read by a library.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "bt_core/cli/replay_printer.h"

namespace coppice {
namespace {

using nlohmann::json;

TEST(ReplayJson, WritesAnyTextSoThatItCanBeReadBack) {
  for (const std::string text : {"", "plain", "\"quoted\" \\ and \n\t\x01\x7f",
                                 "n\xc3\xa4her \xe2\x82\xac \xf0\x9f\xa4\x96"}) {
    EXPECT_EQ(json::parse(JsonText(text)), text);
  }
}

TEST(ReplayJson, ReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(JsonText("a\xff"
                     "b"),
            "\"a\xEF\xBF\xBD"
            "b\"");
  std::mt19937 random(4);
  for (int i = 0; i < 5000; ++i) {
    std::string text(random() % 12, '\0');
    for (char& c : text) c = static_cast<char>(random());
    EXPECT_NO_THROW(json::parse(JsonText(text))) << JsonText(text);
  }
}

TEST(ReplayJson, WritesOneObjectPerLine) {
  RecordHeader header;
  header.start = std::chrono::seconds(1);
  header.main_tree = "Main";
  header.metadata = {{"robot", "sobi"}};
  header.nodes = {{"a", "A"}};
  header.slots = {{"Main", "key", "int"}};
  std::ostringstream out;
  const auto printer = MakeJsonPrinter(out, header);
  printer->Header(header);
  RecordedTick tick{std::chrono::milliseconds(2500),
                    7,
                    Status::kRunning,
                    {{0, Status::kIdle, Status::kRunning}},
                    {{0, "5"}, {0, std::nullopt}},
                    {{0, "hello"}}};
  printer->Entry(tick);
  printer->Entry(RecordedNote{header.start, "kind", "text"});
  printer->Entry(RecordedGap{header.start, 1, 2, 3, 4, {}});
  printer->Entry(RecordedEnd{header.start, 9});
  printer->Damage({12, "broken"});
  ReplaySummary summary(header);
  summary.Add(tick);
  printer->Summary(summary);

  std::vector<json> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[0]["metadata"]["robot"], "sobi");
  EXPECT_EQ(lines[0]["nodes"], json::parse(R"(["a"])"));
  EXPECT_EQ(lines[1], json::parse(R"({"type": "tick", "time": 1.5, "tick": 7, "result": "RUNNING",
    "changes": [{"node": "a", "from": "IDLE", "to": "RUNNING"}],
    "writes": [{"scope": "Main", "key": "key", "value": "5"},
               {"scope": "Main", "key": "key", "value": null}],
    "messages": [{"node": "a", "text": "hello"}]})"));
  EXPECT_EQ(lines[2]["kind"], "kind");
  EXPECT_EQ(lines[3]["lost_notes"], 4);
  EXPECT_EQ(lines[4]["ticks"], 9);
  EXPECT_EQ(lines[5]["offset"], 12);
  EXPECT_EQ(lines[6]["seconds"], 1.5);
  EXPECT_EQ(lines[6]["closed"], false);
}

}  // namespace
}  // namespace coppice
