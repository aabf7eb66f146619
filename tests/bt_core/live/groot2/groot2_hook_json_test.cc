#include "bt_core/live/groot2/groot2_hook_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace coppice::groot2 {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::json;

TEST(Groot2HookJson, IsWhatTheProtocolWants) {
  Hook hook;
  EXPECT_EQ(Json::parse(WriteHookInsert(hook, 5)), Json({{"enabled", true},
                                                         {"uid", 5},
                                                         {"mode", 0},
                                                         {"once", false},
                                                         {"desired_status", "SKIPPED"},
                                                         {"position", 0}}));
  hook.action = HookAction::kReplace;
  hook.status = Status::kFailure;
  hook.position = HookPosition::kAfter;
  hook.times = 1;
  EXPECT_EQ(Json::parse(WriteHookInsert(hook, 5)), Json({{"enabled", true},
                                                         {"uid", 5},
                                                         {"mode", 1},
                                                         {"once", true},
                                                         {"desired_status", "FAILURE"},
                                                         {"position", 1}}));
  EXPECT_EQ(Json::parse(WriteHookRemove(5, HookPosition::kAfter)),
            Json({{"uid", 5}, {"position", 1}}));
  EXPECT_EQ(Json::parse(WriteUnlock(5, HookPosition::kBefore, Status::kSuccess)),
            Json({{"uid", 5},
                  {"position", 0},
                  {"desired_status", "SUCCESS"},
                  {"remove_when_done", false}}));
}

TEST(Groot2HookJson, ReadsWhatItWrites) {
  Hook hook;
  hook.action = HookAction::kReplace;
  hook.status = Status::kFailure;
  hook.position = HookPosition::kAfter;
  hook.times = 1;
  hook.enabled = false;
  const auto read = ReadHooks("[" + WriteHookInsert(hook, 5) + "]");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(WriteHookInsert(read[0].hook, read[0].uid), WriteHookInsert(hook, 5));
}

TEST(Groot2HookJson, PassesOverWhatIsNoHook) {
  for (const char* json : {"", "null", "7", "{}", "[3]", R"([{"uid":70000}])"}) {
    EXPECT_THAT(ReadHooks(json), IsEmpty()) << json;
  }
}

// Each is compared with each.
TEST(Groot2HookJson, ReadsNoMoreThanAThousand) {
  std::string json = "[";
  for (int i = 0; i < 3000; ++i) {
    json += (i == 0 ? "" : ",") + WriteHookInsert({}, static_cast<std::uint16_t>(i));
  }
  EXPECT_EQ(ReadHooks(json + "]").size(), 1000u);
}

TEST(Groot2HookJson, SaysWhatIsTooMuchForTheProtocol) {
  Hook hook;
  EXPECT_EQ(CheckHook(hook).problem(), "");
  hook.condition = "x";
  EXPECT_THAT(CheckHook(hook).problem(), HasSubstr("conditions"));
  hook = Hook();
  hook.times = 2;
  EXPECT_THAT(CheckHook(hook).problem(), HasSubstr("count"));
  hook = Hook();
  hook.action = HookAction::kDelay;
  EXPECT_THAT(CheckHook(hook).problem(), HasSubstr("delay"));
  hook.action = HookAction::kReplace;
  hook.status = Status::kRunning;
  EXPECT_THAT(CheckHook(hook).problem(), HasSubstr("only SUCCESS and FAILURE"));
}

TEST(Groot2HookJson, FindsNodesByPathAndType) {
  TreeDescription tree;
  tree.main_tree = "Main";
  for (const auto& [path, id] : std::vector<std::pair<std::string, std::string>>{
           {"top", "Sequence"}, {"dock", "Dock"}, {"dock/Drive::3", "Drive"}}) {
    tree.nodes.emplace_back();
    tree.nodes.back().path = path;
    tree.nodes.back().id = id;
  }
  EXPECT_THAT(FindNodes(tree, "top"), ElementsAre(0u));
  EXPECT_THAT(FindNodes(tree, "Main/dock/Drive::3"), ElementsAre(2u));
  EXPECT_THAT(FindNodes(tree, "dock/Drive"), ElementsAre(2u));
  EXPECT_THAT(FindNodes(tree, "Drive"), IsEmpty());
}

}  // namespace
}  // namespace coppice::groot2
