#include "bt_core/cli/live/live_commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/cli/verbs.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = LiveCommand::Kind;

Options Given(const std::map<std::string, std::vector<std::string>>& values) {
  Options options = ParseOptions(LiveVerbCommand(), {"robot"});
  for (const auto& [name, given] : values) options.values.at(name) = given;
  return options;
}

TEST(LiveCommands, AreSentHooksFirst) {
  const auto commands = ReadCommands(Given({{"--continue", {""}},
                                            {"--break", {"a", "b"}},
                                            {"--if", {"x > 1"}},
                                            {"--inject", {"c=FAILUREx3"}},
                                            {"--delay", {"d=250"}},
                                            {"--set", {"dock/speed=0.5=x"}}}))
                            .value();
  ASSERT_EQ(commands.size(), 6u);
  EXPECT_EQ(commands[0].command.hook.path, "a");
  EXPECT_EQ(commands[0].command.hook.condition, "x > 1");
  EXPECT_EQ(commands[1].command.hook.condition, "");
  EXPECT_EQ(commands[1].option, "--break b");
  EXPECT_EQ(commands[2].command.hook.action, HookAction::kReplace);
  EXPECT_EQ(commands[2].command.hook.status, Status::kFailure);
  EXPECT_EQ(commands[2].command.hook.times, 3u);
  EXPECT_EQ(commands[3].command.hook.delay, std::chrono::milliseconds(250));
  EXPECT_EQ(commands[4].command.scope, "dock");
  EXPECT_EQ(commands[4].command.key, "speed");
  EXPECT_EQ(commands[4].command.value, "0.5=x");
  EXPECT_EQ(commands[5].command.kind, Kind::kContinue);
}

TEST(LiveCommands, SayWhatIsWrongWithThem) {
  for (const auto& [option, value, text] :
       std::vector<std::array<const char*, 3>>{{"--inject", "a", "expected PATH=STATUS"},
                                               {"--inject", "a=IDLE", "expected PATH=STATUS"},
                                               {"--inject", "a=FAILUREx0", "expected PATH=STATUS"},
                                               {"--inject", "=FAILURE", "expected PATH=STATUS"},
                                               {"--delay", "a=soon", "expected PATH=MILLISECONDS"},
                                               {"--delay", "a=0", "expected PATH=MILLISECONDS"},
                                               {"--set", "a", "expected KEY=VALUE"},
                                               {"--if", "x", "needs a --break"}}) {
    EXPECT_THAT(ReadCommands(Given({{option, {value}}})).problem(), HasSubstr(text));
  }
}

TEST(LiveCommands, AnInjectionMayBeWithoutEnd) {
  Hook hook;
  EXPECT_TRUE(ReadInjection("a=b=SKIPPED", hook));
  EXPECT_EQ(hook.path, "a=b");
  EXPECT_EQ(hook.status, Status::kSkipped);
  EXPECT_EQ(hook.times, 0u);
}

}  // namespace
}  // namespace coppice
