#include "robot_app/storage/export/csv_table.h"

#include <gtest/gtest.h>

namespace coppice::robot::storage {
namespace {

const std::string kDefinition = "P p\ntime t\nfloat64[] list\nstring s\n" + std::string(80, '=') +
                                "\nMSG: a/P\nfloat64 x\nfloat64 y\n";

TEST(CsvTable, HasAColumnForEachField) {
  EXPECT_EQ(CsvHeader(ParseDefinition("a/B", kDefinition).value()).value(),
            "time,stamp,p.x,p.y,t,list,s\n");
}

TEST(CsvTable, RefusesFieldsThatMultiply) {
  std::string definition = "C0 a\nC0 b\n";
  for (int i = 0; i < 30; ++i) {
    const std::string next = "C" + std::to_string(i + 1);
    definition += "MSG: a/C" + std::to_string(i) + "\n" + next + " a\n" + next + " b\n";
  }
  definition += "MSG: a/C30\nint8 x\n";
  EXPECT_FALSE(CsvHeader(ParseDefinition("a/B", definition).value()));
}

TEST(CsvTable, WritesListsAndTextsIntoOneCell) {
  const StoredMessage message{
      "2025-11-25 08:30:00.000000", 7, "/a", std::make_shared<MessageType>(),
      R"({"p":{"x":0.1,"y":"NaN"},"t":{"secs":1,"nsecs":5},"list":[1,2.5],"s":"a \"b\""})"};
  EXPECT_EQ(*CsvLine(ParseDefinition("a/B", kDefinition).value(), message),
            "2025-11-25 08:30:00.000000,7,0.1,NaN,1.000000005,\"[1,2.5]\",\"a \"\"b\"\"\"\n");
}

TEST(CsvTable, RefusesADocumentOfAnotherType) {
  const StoredMessage message{"", 0, "/a", std::make_shared<MessageType>(), "{}"};
  EXPECT_FALSE(CsvLine(ParseDefinition("a/B", kDefinition).value(), message));
}

}  // namespace
}  // namespace coppice::robot::storage
