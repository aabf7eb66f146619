#include "bt_core/live/client/client_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::json;

TEST(ClientJson, WritesCommandsAsTheRobotWantsThem) {
  Hook hook;
  hook.path = "a/b";
  hook.position = HookPosition::kAfter;
  hook.action = HookAction::kReplace;
  hook.status = Status::kFailure;
  hook.condition = R"(x > "1")";
  hook.times = 3;
  const Json json = Json::parse(WriteCommand(SetHook(hook), 2));
  EXPECT_EQ(json, Json({{"do", "hook"},
                        {"tree", 2},
                        {"node", "a/b"},
                        {"position", "after"},
                        {"action", "replace"},
                        {"status", "FAILURE"},
                        {"condition", R"(x > "1")"},
                        {"from_hit", 1},
                        {"times", 3},
                        {"enabled", true}}));
  hook = Hook();
  hook.node = NodeIndex{7};
  hook.action = HookAction::kDelay;
  hook.delay = std::chrono::milliseconds(1500);
  const Json delay = Json::parse(WriteCommand(SetHook(hook), 0));
  EXPECT_EQ(delay["node"], 7);
  EXPECT_EQ(delay["delay_ms"], 1500.0);
  LiveCommand go_on = MakeCommand(LiveCommand::Kind::kContinue);
  go_on.result = Status::kSuccess;
  EXPECT_EQ(Json::parse(WriteCommand(go_on, 0)),
            Json({{"do", "continue"}, {"tree", 0}, {"result", "SUCCESS"}}));
  EXPECT_EQ(Json::parse(WriteCommand(MakeCommand(LiveCommand::Kind::kStepNode), 0)),
            Json({{"do", "step"}, {"tree", 0}, {"to", "node"}}));
}

TEST(ClientJson, SubscribesFromAFrameOfARunOrFromNow) {
  SubscribeRequest request;
  EXPECT_EQ(Json::parse(WriteSubscribe(request)), Json({{"do", "subscribe"}, {"tree", 0}}));
  request.with_past = false;
  EXPECT_EQ(Json::parse(WriteSubscribe(request))["from"], "now");
  request.run[0] = 0xab;
  request.from = 17;
  const Json json = Json::parse(WriteSubscribe(request));
  EXPECT_EQ(json["from"], 17);
  EXPECT_EQ(json["run"], "ab000000000000000000000000000000");
  EXPECT_EQ(ReadRunId("ab000000000000000000000000000000"), request.run);
  EXPECT_EQ(ReadRunId("xb000000000000000000000000000000"), RunId());
}

TEST(ClientJson, ReadsWhatARobotSaysOfItself) {
  const Expected<HelloReply> reply =
      ReadHello(R"({"protocol":1,"control":"the robot moves",)"
                R"("trees":[{"tree":1,"name":"b"},{"tree":0,"name":"a"}]})");
  ASSERT_TRUE(reply) << reply.problem();
  EXPECT_EQ(reply->refusal, "the robot moves");
  EXPECT_THAT(reply->trees, ElementsAre("a", "b"));
  EXPECT_EQ(ReadHello(R"({"protocol":1,"control":true,"trees":[]})")->refusal, "");
  EXPECT_THAT(ReadHello(R"({"protocol":2})").problem(), HasSubstr("version 2"));
}

TEST(ClientJson, ReadsNotices) {
  const NoticeMessage message = ReadNotice(
      R"({"event":"refused","tree":3,"text":"it moves","stop":{"where":"after","node":4,)"
      R"("path":"x","result":"FAILURE","hook":5,"tick":6}})");
  EXPECT_EQ(message.tree, 3u);
  EXPECT_EQ(message.notice.path, "x");
  const DebugEvent& event = message.notice.event;
  EXPECT_EQ(event.kind, DebugEvent::Kind::kRefused);
  EXPECT_EQ(event.reason, "it moves");
  EXPECT_EQ(event.stop.where, DebugStop::Where::kAfter);
  EXPECT_EQ(event.stop.node, 4u);
  EXPECT_EQ(event.stop.result, Status::kFailure);
  EXPECT_EQ(event.stop.hook, 5u);
  EXPECT_EQ(event.stop.tick, 6u);
}

TEST(ClientJson, IsNotDisturbedByNonsense) {
  for (const char* text :
       {"", "[]", "{", "17", R"({"error":5})", R"({"trees":[1,{"tree":99999999999}]})",
        R"({"stop":7,"tree":"x","event":[]})", "\xff\xfe"}) {
    EXPECT_FALSE(ReadHello(text));
    EXPECT_EQ(ReadSubscribe(text).ok(), ReadReply(text).ok());
    ReadNotice(text);
  }
  EXPECT_TRUE(ReadReply(R"({"a":)" + std::string(10 << 20, '[')));
  EXPECT_EQ(
      ReadReply(R"({"error":"x","a":)" + std::string(100000, '[') + std::string(100000, ']') + "}")
          .problem(),
      "")
      << "it is nested too deep";
  EXPECT_NE(ReadReply(R"({"error":5})").problem(), "");
  EXPECT_EQ(ReadReply(WriteAbandoned("gone")).problem(), "gone");
}

}  // namespace
}  // namespace coppice
