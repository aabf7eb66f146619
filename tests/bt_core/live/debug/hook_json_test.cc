#include "bt_core/live/debug/hook_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/bt_core/live/watched_tree.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

std::string WhyNot(const char* json) {
  try {
    ReadHook(Json::parse(json));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(HookJson, ReadsAHookWithAllItsMembers) {
  const Hook hook = ReadHook(Json::parse(R"({"node": "a/b", "position": "after",
      "action": "replace", "status": "FAILURE", "condition": "x > 1", "from_hit": 3, "times": 2,
      "enabled": false})"));
  EXPECT_EQ(hook.path, "a/b");
  EXPECT_EQ(hook.position, HookPosition::kAfter);
  EXPECT_EQ(hook.action, HookAction::kReplace);
  EXPECT_EQ(hook.status, Status::kFailure);
  EXPECT_EQ(hook.condition, "x > 1");
  EXPECT_EQ(hook.from_hit, 3u);
  EXPECT_EQ(hook.times, 2u);
  EXPECT_FALSE(hook.enabled);
}

TEST(HookJson, StopsBeforeTheNodeUnlessToldOtherwise) {
  const Hook hook = ReadHook(Json::parse(R"({"node": 7})"));
  EXPECT_EQ(hook.node, 7u);
  EXPECT_EQ(hook.position, HookPosition::kBefore);
  EXPECT_EQ(hook.action, HookAction::kStop);
  EXPECT_EQ(hook.from_hit, 1u);
  EXPECT_EQ(hook.times, 0u);
  EXPECT_TRUE(hook.enabled);
}

TEST(HookJson, ReadsADelayInMilliseconds) {
  const Hook hook = ReadHook(Json::parse(R"({"node": 1, "action": "delay", "delay_ms": 2.5})"));
  EXPECT_EQ(hook.delay, std::chrono::microseconds(2500));
}

TEST(HookJson, SaysWhatIsWrong) {
  EXPECT_THAT(WhyNot("{}"), HasSubstr("node: which one?"));
  EXPECT_THAT(WhyNot(R"({"node": -1})"), HasSubstr("node: expected"));
  EXPECT_THAT(WhyNot(R"({"node": 4294967295})"), HasSubstr("node: expected"));
  EXPECT_THAT(WhyNot(R"({"node": ""})"), HasSubstr("node: expected"));
  EXPECT_THAT(WhyNot(R"({"node": 1, "position": "behind"})"),
              HasSubstr(R"(position "behind": expected one of "before", "after")"));
  EXPECT_THAT(WhyNot(R"({"node": 1, "action": "replace"})"), HasSubstr("'status' not found"));
  EXPECT_THAT(WhyNot(R"({"node": 1, "action": "replace", "status": "IDLE"})"),
              HasSubstr(R"(expected one of "RUNNING")"));
  EXPECT_THAT(WhyNot(R"({"node": 1, "action": "delay", "delay_ms": -1})"), HasSubstr("delay_ms"));
  EXPECT_THAT(WhyNot(R"({"node": 1, "action": "delay", "delay_ms": 1e300})"), HasSubstr("a day"));
  EXPECT_THAT(WhyNot(R"({"node": 1, "times": 4294967296})"), HasSubstr("times: expected"));
  EXPECT_THAT(WhyNot(R"({"node": 1, "condition": 5})"), HasSubstr("type must be string"));
}

TEST(HookJson, WritesWhatItReads) {
  HookInfo info;
  info.id = HookId{4};
  info.hook = ReadHook(Json::parse(R"({"node": "p", "action": "delay", "delay_ms": 2})"));
  info.nodes = {NodeIndex{3}, NodeIndex{9}};
  info.hits = 5;
  info.problem = "no key x";
  const Json json = WriteHook(info, true);
  EXPECT_EQ(json["hook"], 4);
  EXPECT_EQ(json["mine"], true);
  EXPECT_EQ(json["nodes"], Json({3, 9}));
  EXPECT_EQ(json["problem"], "no key x");
  EXPECT_EQ(json["delay_ms"], 2);
  EXPECT_EQ(ReadHook(json).path, "p");
  EXPECT_EQ(ReadHook(json).delay, info.hook.delay);
}

TEST(HookJson, WritesWhereATreeStands) {
  const auto program = WatchedProgram();
  EXPECT_TRUE(WriteStop({}, *program).is_null());
  const DebugStop stop{DebugStop::Where::kAfter, NodeIndex{5}, Status::kRunning, HookId{2}, 77};
  EXPECT_EQ(WriteStop(stop, *program), Json::parse(R"({"where": "after", "node": 5, "path": "last",
      "result": "RUNNING", "hook": 2, "tick": 77})"));
  const DebugStop between{DebugStop::Where::kBetweenTicks, kNoNode, Status::kIdle, kNoHook, 3};
  EXPECT_EQ(WriteStop(between, *program), Json::parse(R"({"where": "between_ticks", "tick": 3})"));
}

}  // namespace
}  // namespace coppice
