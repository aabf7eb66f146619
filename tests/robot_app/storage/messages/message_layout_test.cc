#include "robot_app/storage/messages/message_layout.h"

#include <gtest/gtest.h>

namespace coppice::robot::storage {
namespace {

const std::string kLine(80, '=');

TEST(ParseDefinition, TakesFieldsAndLeavesConstantsAndRemarksOut) {
  const auto layout = ParseDefinition("a/B",
                                      "# remark\n\nint32 x # of it\nuint8 OK=0\nstring N=a # b\n"
                                      "float64[3] three\nchar[] any\r\n");
  ASSERT_TRUE(layout) << layout.problem();
  ASSERT_EQ(layout->fields.size(), 3u);
  EXPECT_EQ(layout->fields[0].name, "x");
  EXPECT_EQ(layout->fields[0].kind, FieldKind::kInt32);
  EXPECT_EQ(layout->fields[1].count, MessageField::Count::kFixed);
  EXPECT_EQ(layout->fields[1].length, 3u);
  EXPECT_EQ(layout->fields[2].count, MessageField::Count::kAny);
  EXPECT_EQ(layout->fields[2].kind, FieldKind::kUint8);
}

TEST(ParseDefinition, FindsTypesOfItsPackageAndTheHeader) {
  const auto layout = ParseDefinition(
      "a/B", "Header header\nC c\nd/E[] e\n" + kLine + "\nMSG: std_msgs/Header\ntime stamp\n" +
                 kLine + "\nMSG: a/C\nbool x\n" + kLine + "\nMSG: d/E\nF f\n" + kLine +
                 "\nMSG: d/F\nint8 y\n");
  ASSERT_TRUE(layout) << layout.problem();
  EXPECT_EQ(layout->messages[layout->fields[0].message].type, "std_msgs/Header");
  EXPECT_EQ(layout->messages[layout->fields[1].message].type, "a/C");
  EXPECT_EQ(layout->messages[layout->fields[2].message].type, "d/E");
  EXPECT_EQ(layout->messages[1].size, 8u);
  EXPECT_EQ(layout->messages[0].size, std::nullopt);
}

TEST(ParseDefinition, CountsASizeBeyondAllMeasureAsTheLargest) {
  const auto layout =
      ParseDefinition("a/B", "C[4000000000] c\n" + kLine + "\nMSG: a/C\nD[4000000000] d\n" + kLine +
                                 "\nMSG: a/D\nuint8[4000000000] e\n");
  ASSERT_TRUE(layout) << layout.problem();
  EXPECT_EQ(layout->messages[0].size, UINT64_MAX);
}

struct Wrong {
  const char* definition;
  const char* problem;
};
class WrongDefinition : public testing::TestWithParam<Wrong> {};

TEST_P(WrongDefinition, IsToldWithItsLine) {
  EXPECT_EQ(ParseDefinition("a/B", GetParam().definition).problem(), GetParam().problem);
}
INSTANTIATE_TEST_SUITE_P(
    All, WrongDefinition,
    testing::Values(Wrong{"\nint32", "a/B: line 2: expected a type and a name"},
                    Wrong{"int32 a b", "a/B: line 1: expected a name, not \"a b\""},
                    Wrong{"int32 a\"", "a/B: line 1: expected a name, not \"a\"\""},
                    Wrong{"int32[2 x", "a/B: line 1: expected a \"]\""},
                    Wrong{"int32[-2] x", "a/B: line 1: expected the length of an array"},
                    Wrong{"int32[5000000000] x", "a/B: line 1: expected the length of an array"},
                    Wrong{"int32 a\nint8 a", "a/B: line 2: a is there twice"},
                    Wrong{"C c", "a/B: there is no definition of C"},
                    Wrong{"MSG: a/B", "a/B: line 1: a/B is defined twice"},
                    Wrong{"B b", "a/B is nested too deep"}));

TEST(ParseDefinition, TakesNoTypeWhoseNameWouldNeedQuotes) {
  const std::string problem = "expected the name of a type";
  EXPECT_EQ(ParseDefinition("a/B\"", "").problem(), problem);
  EXPECT_EQ(ParseDefinition("", "").problem(), problem);
  EXPECT_EQ(ParseDefinition("a/B", "x\",\"y[] z\nMSG: x\",\"y\n").problem(),
            "a/B: line 2: " + problem);
}

TEST(ParseDefinition, CountsAnArrayOfNothingAsNothingWhateverItIsOf) {
  const auto layout = ParseDefinition("a/B", "string[0] x\nint32 y");
  ASSERT_TRUE(layout) << layout.problem();
  EXPECT_EQ(layout->messages[0].size, 4u);
}

TEST(ParseDefinition, RefusesWhatIsTooLong) {
  EXPECT_FALSE(ParseDefinition("a/B", std::string(kLongestDefinition + 1, '\n')));
}

}  // namespace
}  // namespace coppice::robot::storage
