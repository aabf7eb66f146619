#include "bt_core/base/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace coppice {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

const Command& Sample() {
  static const Command command{"coppice sample",
                               "a sample",
                               {"[FILE...]", 0, 3},
                               "Shows what options are.",
                               {CommandOption::Whole("--ticks", "N", 0, 100, "how many"),
                                CommandOption::Real("--from", "SECONDS", -10, 10, "since when"),
                                CommandOption::Text("--tree", "ID", "which tree"),
                                CommandOption::OneOf("--sort", {"time", "name"}, "by what"),
                                CommandOption::Text("--set", "KEY=VALUE", "values").List(),
                                CommandOption::Flag("--xml", "as XML")}};
  return command;
}

Options Parse(const std::vector<std::string>& arguments) {
  return ParseOptions(Sample(), arguments);
}

std::string ErrorOf(const std::vector<std::string>& arguments) {
  CaptureStderr();
  EXPECT_EQ(Parse(arguments).exit, 2);
  return GetCapturedStderr();
}

TEST(CommandLine, TellsFilesFromOptions) {
  const Options options = Parse({"a.xml", "--ticks", "5", "--xml", "b.xml"});
  ASSERT_FALSE(options.exit);
  EXPECT_THAT(options.files, ElementsAre("a.xml", "b.xml"));
  EXPECT_EQ(options.Whole("--ticks", 1), 5);
  EXPECT_TRUE(options.Has("--xml"));
  EXPECT_FALSE(options.Has("--tree"));
}

TEST(CommandLine, GivesTheDefaultForWhatIsMissing) {
  EXPECT_EQ(Parse({}).Get("--tree", "Main"), "Main");
  EXPECT_EQ(Parse({}).Whole("--ticks", 7), 7);
  EXPECT_EQ(Parse({}).Real("--from", 0.5), 0.5);
}

TEST(CommandLine, AnOptionMayBeGivenMoreThanOnce) {
  const Options options = Parse({"--tree", "A", "--tree", "B"});
  EXPECT_EQ(options.Get("--tree"), "B");
  EXPECT_THAT(options.GetAll("--tree"), ElementsAre("A", "B"));
  EXPECT_TRUE(options.GetAll("--ticks").empty());
}

TEST(CommandLine, AListTakesAllUpToTheNextOption) {
  const Options options = Parse({"a.xml", "--set", "k=-1", "l=2", "--xml", "--set", "m=3"});
  EXPECT_THAT(options.GetAll("--set"), ElementsAre("k=-1", "l=2", "m=3"));
  EXPECT_THAT(options.files, ElementsAre("a.xml"));
}

TEST(CommandLine, ANegativeNumberIsAValue) {
  EXPECT_EQ(Parse({"--from", "-2.5"}).Real("--from", 0), -2.5);
}

TEST(CommandLine, ADashAloneIsAFile) { EXPECT_THAT(Parse({"-"}).files, ElementsAre("-")); }

TEST(CommandLine, BehindTwoDashesAllAreFiles) {
  EXPECT_THAT(Parse({"--", "--xml", "--"}).files, ElementsAre("--xml", "--"));
}

TEST(CommandLine, AnUnknownOptionGetsTheNearest) {
  EXPECT_EQ(ErrorOf({"--tick", "5"}),
            "coppice sample: unknown option --tick (did you mean \"--ticks\"?); see coppice sample "
            "--help\n");
}

TEST(CommandLine, AMissingValueIsAnError) {
  EXPECT_THAT(ErrorOf({"a.xml", "--ticks"}), StartsWith("coppice sample: --ticks: 1 required N"));
}

TEST(CommandLine, NumbersAreWholeAndWithinTheirLimits) {
  for (const char* wrong : {"12x", "1.5", "-1", "101", "", "0x10"}) {
    EXPECT_THAT(ErrorOf({"--ticks", wrong}),
                HasSubstr("--ticks: expected a whole number from 0 to 100, not \"" +
                          std::string(wrong) + "\""));
  }
  EXPECT_THAT(ErrorOf({"--from", "nan"}), HasSubstr("expected a number from -10 to 10"));
}

TEST(CommandLine, AChoiceIsOneOfThose) {
  EXPECT_THAT(ErrorOf({"--sort", "size"}), HasSubstr("expected one of time, name, not \"size\""));
}

TEST(CommandLine, TooManyAndTooFewFilesAreErrors) {
  EXPECT_THAT(ErrorOf({"a", "b", "c", "d"}), HasSubstr("\"d\" is one too many"));
  CaptureStderr();
  EXPECT_EQ(ParseOptions({"p", "", {"FILE", 1, 1}, "", {}}, {}).exit, 2);
  EXPECT_EQ(GetCapturedStderr(), "p: expected FILE; see p --help\n");
}

TEST(CommandLine, WhatIsNeededIsAskedFor) {
  const Command command{"p", "", {}, "", {CommandOption::Text("-o", "FILE", "out").Needed()}};
  CaptureStderr();
  EXPECT_EQ(ParseOptions(command, {}).exit, 2);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("-o is required"));
}

TEST(CommandLine, HelpGoesToTheStandardOutputAndIsNoError) {
  CaptureStdout();
  EXPECT_EQ(Parse({"--help", "--nonsense"}).exit, 0);
  EXPECT_EQ(GetCapturedStdout(), HelpText(Sample()));
}

TEST(CommandLine, HelpNamesEveryOptionAndItsValue) {
  const std::string help = HelpText(Sample());
  EXPECT_THAT(help, StartsWith("usage: coppice sample [options] [FILE...]\n\nShows what"));
  EXPECT_THAT(help, HasSubstr("\n  --ticks N         how many\n"));
  EXPECT_THAT(help, HasSubstr("\n  --sort time|name  by what\n"));
}

TEST(CommandLine, LongHelpIsBrokenAtAHundredCharacters) {
  std::string long_help;
  for (int i = 0; i < 40; ++i) long_help += "words ";
  const Command command{"p", "", {}, "", {CommandOption::Flag("--flag", long_help)}};
  std::istringstream lines(HelpText(command));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST(CommandLine, ToAskForAnOptionThatThereIsNotIsAMistakeInTheProgram) {
  EXPECT_THROW(Parse({}).Has("--treee"), std::out_of_range);
}

}  // namespace
}  // namespace coppice
