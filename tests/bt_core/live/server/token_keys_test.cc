#include "bt_core/live/server/token_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kToken = "a token for tests";

std::string WhyNot(const std::string& token, bool robot = true) {
  try {
    robot ? (void)KeysOfRobot(token) : (void)KeysOfWatcher(token);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(TokenKeys, BothSidesComputeTheSame) {
  const RobotKeys robot = KeysOfRobot(kToken);
  const WatcherKeys control = KeysOfWatcher(kToken);
  EXPECT_EQ(control.robot, robot.robot.public_key);
  EXPECT_EQ(control.client.public_key, robot.control_client);
  EXPECT_EQ(robot.robot.secret_key.size(), 32u);
  EXPECT_EQ(KeysOfRobot(kToken).read_token, robot.read_token) << "the same in every run";
}

TEST(TokenKeys, AReaderKnowsTheRobotButNoSecretOfOthers) {
  const RobotKeys robot = KeysOfRobot(kToken);
  const WatcherKeys reader = KeysOfWatcher(robot.read_token);
  EXPECT_EQ(reader.robot, robot.robot.public_key);
  EXPECT_EQ(reader.client.public_key, robot.read_client);
  EXPECT_NE(robot.read_client, robot.control_client);
  EXPECT_THAT(robot.read_token, StartsWith("read-"));
  EXPECT_EQ(robot.read_token.size(), 5u + 96u);
}

TEST(TokenKeys, AnotherTokenHasOtherKeys) {
  EXPECT_NE(KeysOfRobot(kToken).robot.public_key,
            KeysOfRobot("a token for others").robot.public_key);
}

TEST(TokenKeys, SaysWhatIsWrongWithAToken) {
  EXPECT_THAT(WhyNot("short"), HasSubstr("openssl rand -hex 16"));
  EXPECT_THAT(WhyNot("short", false), HasSubstr("shorter than 16"));
  const std::string read_token = KeysOfRobot(kToken).read_token;
  EXPECT_THAT(WhyNot(read_token), HasSubstr("for readers"));
  EXPECT_THAT(WhyNot(read_token + "00", false), HasSubstr("damaged"));
  EXPECT_THAT(WhyNot(read_token.substr(0, 99) + "xx", false), HasSubstr("damaged"));
  EXPECT_EQ(WhyNot(read_token, false), "");
}

}  // namespace
}  // namespace coppice
