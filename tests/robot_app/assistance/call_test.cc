#include "robot_app/assistance/call.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/robot_app/assistance/local_server.h"

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::SizeIs;

class CallTest : public testing::Test {
 protected:
  bool Call() {
    return CallSupervisors(config_, MakeChannels(config_), "base", "It is dead.", problems_);
  }

  HttpServer broken_{500};
  HttpServer working_;
  AssistanceConfig config_ = [this] {
    AssistanceConfig config;
    config.robot = "Sobi";
    config.channels = {{"broken", ChannelConfig::Kind::kWebhook, broken_.url(), "", "", ""},
                       {"working", ChannelConfig::Kind::kWebhook, working_.url(), "", "", ""}};
    config.supervisors = {{"Ada", {{"broken", ""}}}, {"Ben", {{"broken", ""}, {"working", ""}}}};
    return config;
  }();
  std::string problems_;
};

TEST_F(CallTest, GoesToTheFirstWhoCanBeReached) {
  EXPECT_TRUE(Call());
  EXPECT_THAT(broken_.requests(), SizeIs(2));
  ASSERT_THAT(working_.requests(), SizeIs(1));
  const json message = json::parse(working_.requests()[0].body());
  EXPECT_EQ(message.at("name"), "Ben");
  EXPECT_EQ(message.at("subject"), "base");
  EXPECT_EQ(message.at("headline"), "Sobi tells: base");
  EXPECT_THAT(problems_, HasSubstr("Ada by broken"));
}

TEST_F(CallTest, EndsWithTheFirstMessageThatHasGoneOut) {
  config_.supervisors = {{"Ben", {{"working", ""}}}, {"Ada", {{"working", ""}}}};
  EXPECT_TRUE(Call());
  EXPECT_THAT(working_.requests(), SizeIs(1));
  EXPECT_EQ(problems_, "");
}

TEST_F(CallTest, NamesEveryWayThatFailedIfNobodyCanBeReached) {
  config_.supervisors.pop_back();
  EXPECT_FALSE(Call());
  EXPECT_THAT(problems_, HasSubstr("Ada by broken: "));
  EXPECT_THAT(problems_, HasSubstr("500"));
}

TEST_F(CallTest, WithoutSupervisorsThereIsNobodyToCall) {
  config_.supervisors.clear();
  EXPECT_FALSE(Call());
  EXPECT_THAT(problems_, HasSubstr("names no supervisor"));
}

}  // namespace
}  // namespace coppice::robot::assistance
