#include "robot_app/assistance/assistance_config.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <map>

#include "tests/support/folders.h"

namespace coppice::robot::assistance {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::SizeIs;

class Config : public testing::Test {
 protected:
  AssistanceConfig Load(const std::string& text) {
    const std::string path =
        testing::TempDir() + "supervisors_" + std::to_string(getpid()) + ".yaml";
    std::ofstream(path) << text;
    return LoadFile(path);
  }
  AssistanceConfig LoadFile(const std::string& path) {
    diagnostics_ = {};
    return LoadAssistanceConfig(
        path,
        [this](const std::string& name) {
          const auto found = environment_.find(name);
          return found == environment_.end() ? std::nullopt : std::make_optional(found->second);
        },
        diagnostics_);
  }
  std::string Problems() const { return diagnostics_.ToString(); }

  std::map<std::string, std::string> environment_ = {{"TOKEN", "s3cret"}, {"ADA", "42"}};
  Diagnostics diagnostics_;
};

TEST_F(Config, TheShippedFileWorksWithoutAnyVariable) {
  environment_.clear();
  const AssistanceConfig config = LoadFile(SourceFolder() + "/robot_app/config/supervisors.yaml");
  EXPECT_FALSE(diagnostics_.has_errors()) << Problems();
  ASSERT_THAT(config.supervisors, SizeIs(2));
  EXPECT_EQ(config.supervisors[0].ways[0].channel, "console");
  EXPECT_EQ(config.page.operator_token, "");
  EXPECT_EQ(config.RulesOf("battery").next, seconds(120));
  EXPECT_EQ(config.RulesOf("battery").deadline, config.RulesOf("other").deadline);
}

TEST_F(Config, ChannelsAndWaysAreFilledFromTheEnvironment) {
  const AssistanceConfig config = Load(
      "channels: [{name: telegram, kind: telegram, token: \"${TOKEN}\"}]\n"
      "supervisors: [{name: Ada, reach: [{channel: telegram, to: \"${ADA}\"}]}]\n");
  EXPECT_EQ(Problems(), "");
  EXPECT_EQ(config.channels.at(0).secret, "s3cret");
  EXPECT_EQ(config.supervisors.at(0).ways.at(0).to, "42");
}

TEST_F(Config, WhatNeedsAVariableThatIsNotSetIsLeftOutWithAWarning) {
  const AssistanceConfig config = Load(
      "channels: [{name: matrix, kind: matrix, url: \"https://m\", token: \"${NONE}\"},\n"
      "           {name: console, kind: console}]\n"
      "supervisors: [{name: Ada, reach: [{channel: matrix, to: x}, {channel: console}]}]\n");
  EXPECT_FALSE(diagnostics_.has_errors());
  EXPECT_THAT(Problems(), HasSubstr("NONE is not set"));
  EXPECT_THAT(config.channels, SizeIs(1));
  EXPECT_THAT(config.supervisors.at(0).ways, SizeIs(1));
}

TEST_F(Config, ASecretInTheFileIsAnError) {
  Load("channels: [{name: telegram, kind: telegram, token: 123456}]\n");
  EXPECT_THAT(Problems(), HasSubstr("a secret must not stand in a file"));
  Load("page: {operator_token: hunter2}\n");
  EXPECT_THAT(Problems(), HasSubstr("a secret must not stand in a file"));
}

TEST_F(Config, ATokenOfThePageThatCanBeGuessedIsAnError) {
  environment_["SHORT"] = "123456789012345";
  environment_["LONG"] = "1234567890123456";
  for (const std::string key : {"operator_token", "viewer_token"}) {
    Load("page: {" + key + ": \"${SHORT}\"}\n");
    EXPECT_THAT(Problems(), HasSubstr("the token has 15 characters, at least 16 are needed"));
    Load("page: {" + key + ": \"${LONG}\"}\n");
    EXPECT_EQ(Problems(), "");
  }
}

TEST_F(Config, ATokenDoesNotGoOverHttpToAnotherComputer) {
  Load(
      "channels: [{name: hook, kind: webhook, url: \"http://example.org\", token: "
      "\"${TOKEN}\"}]\n");
  EXPECT_THAT(Problems(), HasSubstr("must not go over http"));
  Load(
      "channels: [{name: hook, kind: webhook, url: \"http://127.0.0.1:80\", token: "
      "\"${TOKEN}\"}]\n");
  EXPECT_EQ(Problems(), "");
}

TEST_F(Config, EverythingThatIsWrongIsSaidAtOnceWithItsLine) {
  Load(
      "robot: R\n"
      "channels:\n"
      "  - {name: a, kind: pigeon}\n"
      "  - {name: a, kind: console, colour: red}\n"
      "supervisors:\n"
      "  - {name: Ada, reach: [{channel: b}]}\n"
      "  - {name: Ada}\n"
      "patience: {remind: 0}\n"
      "page: {port: 99999}\n");
  const std::string problems = Problems();
  EXPECT_THAT(problems, HasSubstr(":3:"));
  EXPECT_THAT(problems, HasSubstr("\"a\" is listed twice"));
  EXPECT_THAT(problems, HasSubstr("colour"));
  EXPECT_THAT(problems, HasSubstr("unknown channel \"b\""));
  EXPECT_THAT(problems, HasSubstr("\"Ada\" is listed twice"));
  EXPECT_THAT(problems, HasSubstr("remind"));
  EXPECT_THAT(problems, HasSubstr("port"));
}

TEST_F(Config, AFileThatIsMissingIsAnError) {
  LoadFile("/nowhere/supervisors.yaml");
  EXPECT_TRUE(diagnostics_.has_errors());
}

}  // namespace
}  // namespace coppice::robot::assistance
