#include "robot_app/knowledge/import/csv_table.h"

#include <gmock/gmock.h>

namespace coppice::robot::knowledge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class CsvTable : public testing::Test {
 protected:
  // Rows as "line: field|field".
  std::vector<std::string> Read(const std::string& text, bool has_others = false) {
    diagnostics_ = {};
    std::vector<std::string> rows;
    ReadCsv("table.csv", BytesOf(text), {{{"name", true}, {"room"}}, has_others}, diagnostics_,
            [&rows](CsvRow& row) {
              rows.push_back(std::to_string(row.where.line) + ": " + row.fields[0] + "|" +
                             row.fields[1]);
            });
    return rows;
  }
  std::string Problems() const { return diagnostics_.ToString(); }
  Diagnostics diagnostics_;
};

TEST_F(CsvTable, FieldsComeInTheOrderThatIsAskedFor) {
  EXPECT_THAT(Read("room,name\n1,ada\n2,bob\n"), ElementsAre("2: ada|1", "3: bob|2"));
  EXPECT_THAT(Read("name\nada"), ElementsAre("2: ada|"));
  EXPECT_EQ(Problems(), "");
}

TEST_F(CsvTable, QuotesBreaksAndOtherSystemsLinesAreRead) {
  EXPECT_THAT(Read("\xEF\xBB\xBFname,room\r\n\"a, \"\"b\"\"\",1\r\n\r\n\"two\nlines\",2\r\nlast,3"),
              ElementsAre("2: a, \"b\"|1", "4: two\nlines|2", "6: last|3"));
  EXPECT_EQ(Problems(), "");
}

TEST_F(CsvTable, EveryWrongRowIsSaidWithItsLine) {
  EXPECT_THAT(Read("name,room\nada\nbob,1,2\ncid,3\n"), ElementsAre("4: cid|3"));
  EXPECT_EQ(Problems(),
            "table.csv:2: error: expected 2 fields, not 1\n"
            "table.csv:3: error: expected 2 fields, not 3\n");
}

TEST_F(CsvTable, AnUnknownColumnIsAnErrorWithTheNearestRightName) {
  Read("name,romo\nada,1\n");
  EXPECT_EQ(Problems(), "table.csv:1: error: unknown column \"romo\" (did you mean \"room\"?)\n");
  EXPECT_THAT(Read("name,romo\nada,1\n", true), ElementsAre("2: ada|"));
  EXPECT_EQ(Problems(), "");
}

TEST_F(CsvTable, AMissingColumnIsAnError) {
  EXPECT_THAT(Read("room\n1\n"), testing::IsEmpty());
  EXPECT_EQ(Problems(), "table.csv:1: error: expected a column \"name\"\n");
  Read("");
  EXPECT_THAT(Problems(), HasSubstr("expected a row that names the columns"));
}

TEST_F(CsvTable, QuotesThatDoNotEndAreAnError) {
  Read("name,room\n\"ada,1\nbob,2\n");
  EXPECT_THAT(Problems(), HasSubstr("expected a closing quote"));
  Read("name,room\n\"ada\"x,1\n");
  EXPECT_THAT(Problems(), HasSubstr("table.csv:2: error: expected a comma behind a closing quote"));
  Read("name,room\n\"" + std::string(3 << 20, 'a'));
  EXPECT_THAT(Problems(), HasSubstr("expected a closing quote"));
}

TEST_F(CsvTable, OtherEncodingsAreAnError) {
  Read("name,room\nM\xFCller,1\n");
  EXPECT_EQ(Problems(), "table.csv:2: error: expected UTF-8; save the file in that encoding\n");
}

}  // namespace
}  // namespace coppice::robot::knowledge
