// Figures of a run, as a table and as JSON.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "bt_core/analysis/statistics.h"

namespace coppice {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

NodeStatistics Node(const std::string& path, std::uint64_t ticks, Duration p95,
                    std::uint64_t flips) {
  NodeStatistics node;
  node.path = path;
  node.id = "Go";
  node.ticks = ticks;
  node.flips = flips;
  if (p95 > Duration(0)) node.activations = {4, p95 / 2, p95, p95, p95 * 2};
  return node;
}

Statistics Some() {
  Statistics some;
  some.ticks = 20;
  some.time = std::chrono::seconds(120);
  some.nodes = {Node("a", 5, milliseconds(3), 0), Node("b", 9, microseconds(15), 7),
                Node("c", 0, Duration(0), 0), Node("d", 9, milliseconds(3), 7)};
  return some;
}

// Last words of the rows.
std::string Rows(const std::string& table) {
  std::istringstream lines(table);
  std::string nodes;
  bool in_table = false;
  for (std::string line; std::getline(lines, line);) {
    if (in_table) nodes += line.substr(line.rfind(' ') + 1);
    in_table |= line.find("flips/min") != std::string::npos;
  }
  return nodes;
}

std::string RowOf(const std::string& table, const std::string& node) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 3 && line.substr(line.size() - node.size() - 2) == "  " + node) return line;
  }
  return {};
}

TEST(StatisticsText, RowsStandInTheOrderThatIsAskedForAndEqualOnesAsInTheTree) {
  EXPECT_EQ(Rows(PrintStatistics(Some(), StatisticsOrder::kTree)), "abcd");
  EXPECT_EQ(Rows(PrintStatistics(Some(), StatisticsOrder::kTicks)), "bdac");
  EXPECT_EQ(Rows(PrintStatistics(Some(), StatisticsOrder::kTime)), "adbc");
  EXPECT_EQ(Rows(PrintStatistics(Some(), StatisticsOrder::kFlips)), "bdac");
}

TEST(StatisticsText, TimesHaveThreeDigitsAndTheirUnit) {
  const std::string table = PrintStatistics(Some(), StatisticsOrder::kTree);
  EXPECT_EQ(table.rfind("20 ticks in 120 s\n", 0), 0U) << table;
  const std::string b = RowOf(table, "b");
  EXPECT_NE(b.find("7.50 us"), std::string::npos) << b;
  EXPECT_NE(b.find("15.0 us"), std::string::npos) << b;
  EXPECT_NE(b.find("30.0 us"), std::string::npos) << b;
}

TEST(StatisticsText, ANodeThatWasNeverTickedHasNoTimes) {
  const std::string c = RowOf(PrintStatistics(Some(), StatisticsOrder::kTree), "c");
  EXPECT_NE(c.find("never   never"), std::string::npos) << c;
  EXPECT_EQ(c.find(" s"), std::string::npos) << c;
}

TEST(StatisticsText, SaysWhatIsMissingAndHowLongTicksTook) {
  Statistics some = Some();
  EXPECT_EQ(PrintStatistics(some, StatisticsOrder::kTree).find("duration of a tick"),
            std::string::npos);
  some.lost_ticks = 3;
  some.tick_durations = {20, Duration(999), microseconds(1), milliseconds(10), milliseconds(999)};
  const std::string text = PrintStatistics(some, StatisticsOrder::kTree);
  EXPECT_NE(text.find(", 3 more are missing\n"), std::string::npos) << text;
  EXPECT_NE(text.find("duration of a tick: p50 999 ns, p95 1.00 us, p99 10.0 ms, max 999 ms\n"),
            std::string::npos)
      << text;
}

TEST(StatisticsText, JsonHasSecondsAndLeavesOutQuantilesOfNothing) {
  const auto json = nlohmann::json::parse(StatisticsToJson(Some(), StatisticsOrder::kTicks));
  EXPECT_EQ(json["seconds"], 120);
  EXPECT_EQ(json["nodes"][0]["node"], "b");
  EXPECT_EQ(json["nodes"][0]["activations"]["p95"], 0.000015);
  EXPECT_EQ(json["nodes"][3]["node"], "c");
  EXPECT_EQ(json["nodes"][3]["activations"], nlohmann::json({{"count", 0}}));
  EXPECT_EQ(json["tick_durations"], nlohmann::json({{"count", 0}}));
}

}  // namespace
}  // namespace coppice
