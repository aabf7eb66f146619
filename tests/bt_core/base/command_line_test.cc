#include "bt_core/base/command_line.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

std::optional<Options> Parse(const std::vector<std::string>& arguments) {
  return ParseOptions(arguments, {"--ticks", "--tree"}, {"--xml"}, "prog FILE");
}

TEST(CommandLine, TellsFilesFromOptions) {
  const auto options = Parse({"a.xml", "--ticks", "5", "--xml", "b.xml"});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->files, (std::vector<std::string>{"a.xml", "b.xml"}));
  EXPECT_EQ(options->Get("--ticks"), "5");
  EXPECT_TRUE(options->Has("--xml"));
  EXPECT_FALSE(options->Has("--tree"));
}

TEST(CommandLine, GivesTheDefaultForWhatIsMissing) {
  EXPECT_EQ(Parse({})->Get("--tree", "Main"), "Main");
}

TEST(CommandLine, AnOptionMayBeGivenMoreThanOnce) {
  const auto options = Parse({"--tree", "A", "--tree", "B"});
  EXPECT_EQ(options->Get("--tree"), "B");
  EXPECT_EQ(options->GetAll("--tree"), (std::vector<std::string>{"A", "B"}));
  EXPECT_TRUE(options->GetAll("--ticks").empty());
}

TEST(CommandLine, NumbersAreWhole) {
  EXPECT_EQ(Parse({"--ticks", "12"})->GetNumber("--ticks"), 12);
  EXPECT_EQ(Parse({"--ticks", "12x"})->GetNumber("--ticks"), std::nullopt);
  EXPECT_EQ(Parse({})->GetNumber("--ticks"), std::nullopt);
}

TEST(CommandLine, UnknownOptionShowsTheNearestAndTheUsage) {
  CaptureStderr();
  EXPECT_FALSE(Parse({"--tick", "5"}));
  const std::string text = GetCapturedStderr();
  EXPECT_NE(text.find("unknown option --tick did you mean \"--ticks\"?"), std::string::npos)
      << text;
  EXPECT_NE(text.find("usage: prog FILE"), std::string::npos) << text;
}

TEST(CommandLine, MissingValueIsAnError) {
  CaptureStderr();
  EXPECT_FALSE(Parse({"a.xml", "--ticks"}));
  EXPECT_EQ(GetCapturedStderr().find("--ticks needs a value"), 0U);
}

TEST(CommandLine, ADashAloneIsAFile) { EXPECT_EQ(Parse({"-"})->files.size(), 1U); }

}  // namespace
}  // namespace coppice
