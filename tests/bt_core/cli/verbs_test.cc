// What holds for all verbs.
#include "bt_core/cli/verbs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "tests/support/folders.h"

namespace coppice {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::vector<std::string> AllMatches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> matches;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
    matches.push_back((*at)[1]);
  }
  return matches;
}

std::set<std::string> OptionsOf(const Command& command) {
  std::set<std::string> names = {"--help", "-h"};
  for (const CommandOption& option : command.options) names.insert(option.name);
  return names;
}

std::string SampleOf(const CommandOption& option) {
  if (!option.choices.empty()) return option.choices.front();
  const bool is_number =
      option.kind == CommandOption::Kind::kWhole || option.kind == CommandOption::Kind::kReal;
  return is_number ? "1" : "x";
}

// Files, and all options that it says it has.
Arguments EverythingOf(const Command& command) {
  Arguments arguments(command.files.least, "x");
  for (const CommandOption& option : command.options) {
    arguments.push_back(option.name);
    if (option.kind != CommandOption::Kind::kFlag) arguments.push_back(SampleOf(option));
  }
  return arguments;
}

TEST(Verbs, AreSortedByName) {
  for (std::size_t i = 1; i < Verbs().size(); ++i) {
    EXPECT_LT(Verbs()[i - 1].name(), Verbs()[i].name());
  }
}

TEST(Verbs, HelpIsPrintedAndNoError) {
  for (const Verb& verb : Verbs()) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(verb.run({"--help"}), 0) << verb.name();
    EXPECT_EQ(testing::internal::GetCapturedStdout(), HelpText(verb.command())) << verb.name();
  }
}

TEST(Verbs, EveryOptionIsInTheHelpAndAccepted) {
  for (const Verb& verb : Verbs()) {
    EXPECT_FALSE(ParseOptions(verb.command(), EverythingOf(verb.command())).exit) << verb.name();
    for (const CommandOption& option : verb.command().options) {
      EXPECT_THAT(HelpText(verb.command()), HasSubstr("\n  " + option.name + " ")) << verb.name();
    }
  }
}

TEST(Verbs, EveryOptionThatAHelpSpeaksOfIsThere) {
  for (const Verb& verb : Verbs()) {
    const std::set<std::string> known = OptionsOf(verb.command());
    for (const std::string& name :
         AllMatches(HelpText(verb.command()), "[^a-z-](--[a-z][a-z-]*)")) {
      EXPECT_THAT(known, Contains(name)) << verb.name();
    }
  }
}

TEST(Verbs, EveryOptionThatTheManualSpeaksOfIsThere) {
  std::vector<std::filesystem::path> pages = {SourceFolder() + "/README.md"};
  for (const auto& entry : std::filesystem::directory_iterator(SourceFolder() + "/docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  int lines_with_options = 0;
  for (const auto& page : pages) {
    std::ifstream file(page);
    for (std::string line; std::getline(file, line);) {
      for (const Verb& verb : Verbs()) {
        if (line.find("coppice " + verb.name()) == std::string::npos) continue;  // a regex is slow
        for (const std::string& call : AllMatches(line, "coppice " + verb.name() + "( [^`#]*)")) {
          for (const std::string& name : AllMatches(call, "[ \\[(](--?[a-z][a-z-]*)")) {
            EXPECT_THAT(OptionsOf(verb.command()), Contains(name)) << page << ": " << line;
            ++lines_with_options;
          }
        }
      }
    }
  }
  EXPECT_GT(lines_with_options, 30) << "the manual is not read as it should be";
}

TEST(Verbs, CompletionKnowsVerbsOptionsAndChoices) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(RunCompletion({"bash"}), 0);
  const std::string script = testing::internal::GetCapturedStdout();
  EXPECT_THAT(script, HasSubstr("check completion convert"));
  EXPECT_THAT(script, HasSubstr("\"upgrade\") echo \"--help -i -o\""));
  EXPECT_THAT(script, HasSubstr("\"stats --sort\") echo \"tree ticks time flips"));
}

}  // namespace
}  // namespace coppice
