#include "editor/live/values/value_table.h"

#include <gtest/gtest.h>

#include "bt_core/data/value_bytes.h"

namespace coppice::editor {
namespace {

std::string Bytes(const std::string& text) {
  Value value;
  value.Set(text);
  std::string bytes;
  AppendValueBytes(value, bytes);
  return bytes;
}

std::string Print(const std::string& text) {
  const auto table = ReadTable(Bytes(text));
  if (!table) return "none";
  std::string printed;
  for (const std::string& column : table->columns) printed += column + " ";
  for (const auto& row : table->rows) {
    printed += "|";
    for (const ValueTable::Cell& cell : row) printed += " " + cell.text + ";";
  }
  return printed;
}

TEST(ValueTable, AListOfObjectsIsATable) {
  EXPECT_EQ(Print(R"([{"name":"ekf","pid":7},{"name":"map","ok":true,"pid":12.5}])"),
            "name pid ok | ekf; 7; ;| map; 12.5; true;");
  EXPECT_EQ(Print(R"({"stamp":3,"entries":[{"level":"OK"}]})"), "level | OK;");
  EXPECT_TRUE(LooksLikeTable(Bytes(R"([{"a":1}])")));
  EXPECT_TRUE(LooksLikeTable("\x07[{\"a\":1}]")) << "JSON of a type of the application";
}

TEST(ValueTable, EverythingElseIsNone) {
  for (const char* text : {"", "[]", "[1,2]", R"([{"a":1},2])", R"([{"a":)", "{}", "hello",
                           R"({"a":1})", R"({"a":[{"x":1}],"b":[{"y":1}]})"}) {
    EXPECT_EQ(Print(text), "none") << text;
  }
  for (const char* text : {"", "hello", "[1,2]", R"({"a":1})"}) {
    EXPECT_FALSE(LooksLikeTable(Bytes(text))) << text;
  }
  EXPECT_FALSE(LooksLikeTable(""));
}

TEST(ValueTable, NestedValuesAreTheirJson) {
  EXPECT_EQ(Print(R"([{"pose":{"x":1},"tags":["a"],"none":null}])"),
            R"(pose tags none | {"x":1}; ["a"]; ;)");
}

TEST(ValueTable, IsSortedByNumbersOrWords) {
  auto table = *ReadTable(Bytes(R"([{"n":10,"w":"b"},{"n":9,"w":"c"},{"w":"a"}])"));
  table.Sort(0, false);
  EXPECT_EQ(table.rows[0][0].text, "9");
  EXPECT_EQ(table.rows[2][0].text, "") << "what has none comes last";
  table.Sort(1, true);
  EXPECT_EQ(table.rows[0][1].text, "c");
  table.Sort(7, true);
  EXPECT_EQ(table.rows[0][1].text, "c") << "no such column";
}

TEST(ValueTable, AHugeListIsCutOff) {
  std::string text = "[";
  for (int i = 0; i < 3000; ++i) text += (i ? R"(,{"i":)" : R"({"i":)") + std::to_string(i) + "}";
  EXPECT_EQ(ReadTable(Bytes(text + "]"))->rows.size(), ValueTable::kMostRows);
}

TEST(ValueTable, KnowsWhatWordsSay) {
  EXPECT_EQ(LevelOf("READY"), CellLevel::kGood);
  EXPECT_EQ(LevelOf("BACKING_OFF"), CellLevel::kWarning);
  EXPECT_EQ(LevelOf("given_up"), CellLevel::kBad);
  EXPECT_EQ(LevelOf("STOPPED"), CellLevel::kOff);
  EXPECT_EQ(LevelOf("STARTING"), CellLevel::kBusy);
  EXPECT_EQ(LevelOf("ekf"), CellLevel::kNone);
}

}  // namespace
}  // namespace coppice::editor
