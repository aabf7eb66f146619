#include "robot_app/common/yaml_fields.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

class YamlFieldsTest : public testing::Test {
 protected:
  YamlFields Read(const std::string& text) {
    const std::string path = processes::Temporary("yaml_fields_test.yaml");
    std::ofstream(path) << text;
    return YamlFields::Load(path, diagnostics_);
  }
  Diagnostics diagnostics_;
};

TEST_F(YamlFieldsTest, ReadsValuesOfEveryKind) {
  YamlFields file = Read("a: x\nb: 2.5\nc: 3\nd: [p, q]\ne: {f: 1}\ng: [{h: 2}, {h: 3}]\n");
  EXPECT_EQ(file.Text("a").text, "x");
  EXPECT_EQ(file.Number("b", 0, 0, 10), 2.5);
  EXPECT_EQ(file.Seconds("b", 0, 0, 10), std::chrono::milliseconds(2500));
  EXPECT_EQ(file.Integer("c", 0, 0, 10), 3);
  EXPECT_EQ(file.Texts("d").at(1).text, "q");
  YamlFields inner = file.Map("e");
  EXPECT_EQ(inner.Number("f", 0, 0, 10), 1);
  EXPECT_EQ(file.Maps("g").at(1).Number("h", 0, 0, 10), 3);
  EXPECT_FALSE(file.OptionalNumber("missing", 0, 1).has_value());
  EXPECT_EQ(file.Text("missing", "default").text, "default");
  file.Finish();
  inner.Finish();
  EXPECT_EQ(diagnostics_.ToString(), "");
}

TEST_F(YamlFieldsTest, NamesThePlaceAndTheNearestKeyOfAnUnknownOne) {
  YamlFields file = Read("name: x\nnode: y\nnoed: z\n");
  file.Text("name");
  file.Text("node");
  file.Finish();
  EXPECT_THAT(diagnostics_.ToString(),
              HasSubstr(R"(yaml_fields_test.yaml:3:1: error: unknown key "noed" (did you mean )"
                        R"("node"?))"));
}

TEST_F(YamlFieldsTest, ReportsAllProblemsAtOnce) {
  YamlFields file = Read("a: [1]\nb: x\nc: 11\nd: 1.5\ne: 1\ne: 2\nf: fish\ng: 1\n");
  file.Text("a");
  file.Number("b", 0, 0, 1);
  file.Number("c", 0, 0, 10);
  file.Integer("d", 0, 0, 10);
  file.Number("e", 0, 0, 10);
  file.Choice("f", "fast", {"fast", "fish_and_chips"});
  file.Texts("g");
  file.Text("h");
  EXPECT_EQ(diagnostics_.all().size(), 8u) << diagnostics_.ToString();
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr(R"(6:1: error: duplicate key "e")"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr(R"("h" is missing)"));
}

TEST_F(YamlFieldsTest, SaysWhereTheFileIsNoYaml) {
  Read("a: [1, 2\nb: }\n");
  EXPECT_TRUE(diagnostics_.has_errors());
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("yaml_fields_test.yaml:2"));
}

TEST_F(YamlFieldsTest, AnAliasIsWhatItStandsFor) {
  EXPECT_EQ(Read("a: &name [p, q]\nb: *name\n").Texts("b").at(1).text, "q");
  EXPECT_EQ(diagnostics_.ToString(), "");
}

TEST_F(YamlFieldsTest, AliasesThatMultiplyAreAnError) {
  std::string text = "a0: &a0 [x]\n";
  for (int i = 1; i < 25; ++i) {
    const std::string last = "*a" + std::to_string(i - 1), name = "a" + std::to_string(i);
    text += name + ": &" + name + " [" + last + ", " + last + "]\n";
  }
  Read(text);
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("too large with its aliases"));
}

TEST_F(YamlFieldsTest, SomethingWithinItselfIsAnError) {
  Read("a: &a [*a]\n");
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("too large with its aliases"));
}

// Half a megabyte of them would take as many megabytes as there are thousands of values.
TEST_F(YamlFieldsTest, VeryManyValuesAreAnError) {
  std::string text = "a: [";
  for (int i = 0; i < 250'000; ++i) text += "x,";
  Read(text + "x]\n");
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr(":1:1: error: more than 131072 values\n"));
}

TEST_F(YamlFieldsTest, SaysThatTheFileIsMissing) {
  YamlFields::Load("/nowhere/x.yaml", diagnostics_);
  EXPECT_EQ(diagnostics_.ToString(),
            "/nowhere/x.yaml: error: cannot be read: No such file or directory\n");
}

TEST_F(YamlFieldsTest, AScalarOrAnEmptyFileIsNoMapping) {
  Read("just a text\n");
  Read("");
  EXPECT_EQ(diagnostics_.all().size(), 2u);
}

}  // namespace
}  // namespace coppice::robot
