#include "bt_core/live/server/extension_request.h"

#include "tests/bt_core/live/desk_fixture.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::SizeIs;
using Json = nlohmann::json;

class ExtensionRequestTest : public LiveTreeFixture {
 protected:
  explicit ExtensionRequestTest(const LiveTreeOptions& options = {}) : LiveTreeFixture(options) {
    session_.owner = 50;
  }

  Json Run(const std::string& what, const Json& members = Json::object()) {
    const Json as_on_the_wire = Json::parse(members.dump());
    return ExtensionRequest(as_on_the_wire, trees_, session_, may_control_).Run(what);
  }
  std::string WhyNot(const std::string& what, const Json& members = Json::object()) {
    try {
      Run(what, members);
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  LiveTrees trees_{{0, tree_}};
  Session session_;
  bool may_control_ = true;
};

TEST_F(ExtensionRequestTest, ListsTheTrees) {
  Tick(2);
  const Json trees = Run("trees")["trees"];
  ASSERT_THAT(trees, SizeIs(1));
  EXPECT_EQ(trees[0]["name"], "Main");
  EXPECT_EQ(trees[0]["tick"], 2);
  EXPECT_EQ(trees[0]["run"].get<std::string>().size(), 32u);
  EXPECT_TRUE(trees[0]["stop"].is_null());
  EXPECT_EQ(trees[0]["recording_dropped"], 0);
}

TEST_F(ExtensionRequestTest, SubscribesAcknowledgesAndUnsubscribes) {
  const Json reply = Run("subscribe");
  EXPECT_EQ(reply["subscription"], 1);
  EXPECT_EQ(reply["missed"], 0);
  EXPECT_EQ(Run("ack", {{"subscription", 1}, {"next", 3}}), Json::object());
  EXPECT_EQ(Run("unsubscribe", {{"subscription", 1}}), Json::object());
  EXPECT_THAT(session_.subscriptions, SizeIs(0));
  EXPECT_THAT(WhyNot("ack", {{"subscription", 1}, {"next", 3}}), HasSubstr("no subscription 1"));
  EXPECT_THAT(WhyNot("ack", {{"subscription", 1ull << 32 | 2}, {"next", 3}}),
              HasSubstr("no subscription"));
}

TEST_F(ExtensionRequestTest, ASecondSubscriptionToATreeEndsTheFirst) {
  Run("subscribe");
  EXPECT_EQ(Run("subscribe", {{"from", "now"}})["subscription"], 2);
  EXPECT_THAT(session_.subscriptions, ElementsAre(Key(2)));
}

TEST_F(ExtensionRequestTest, GoesOnOnlyInTheSameRun) {
  Tick(3);
  const std::string run = Run("trees")["trees"][0]["run"];
  EXPECT_EQ(Run("subscribe", {{"from", 2}, {"run", run}})["next"], 2);
  EXPECT_EQ(Run("subscribe", {{"from", 2}, {"run", "0"}})["next"], 1);
}

TEST_F(ExtensionRequestTest, SetsChangesEnablesListsAndRemovesHooks) {
  const Json hook = Run("hook", {{"node", 1}, {"action", "replace"}, {"status", "FAILURE"}});
  EXPECT_FALSE(hook.contains("remark"));
  Run("hook", {{"hook", hook["hook"]}, {"node", 2}});
  const Json list = Run("hooks");
  ASSERT_THAT(list["hooks"], SizeIs(1));
  EXPECT_EQ(list["hooks"][0]["node"], 2);
  EXPECT_EQ(list["hooks"][0]["mine"], true);
  Run("enable", {{"hook", hook["hook"]}, {"enabled", false}});
  EXPECT_EQ(Run("hooks")["hooks"][0]["enabled"], false);
  Run("unhook", {{"hook", hook["hook"]}});
  EXPECT_THAT(WhyNot("unhook", {{"hook", hook["hook"]}}), HasSubstr("there is no hook"));
  EXPECT_THAT(WhyNot("enable", {{"hook", 9}, {"enabled", true}}), HasSubstr("there is no hook 9"));
  EXPECT_THAT(Run("hook", {{"node", "elsewhere"}})["remark"].get<std::string>(),
              HasSubstr("elsewhere"));
  Run("unhook");
  EXPECT_THAT(Run("hooks")["hooks"], SizeIs(0));
}

TEST_F(ExtensionRequestTest, SaysWhatIsWrong) {
  EXPECT_EQ(WhyNot("dance"), "\"dance\" is no request of this version");
  EXPECT_THAT(WhyNot("statistics", {{"tree", 3}}), HasSubstr("there is no tree 3"));
  EXPECT_THAT(WhyNot("statistics", {{"tree", -1}}), HasSubstr("tree: expected"));
  EXPECT_THAT(WhyNot("statistics", {{"tree", 1ull << 32}}), HasSubstr("there is no tree"));
  EXPECT_THAT(WhyNot("hook", {{"node", 99}}), HasSubstr("there is no node 99"));
  EXPECT_THAT(WhyNot("hook", {{"node", 1}, {"condition", "number <"}}), HasSubstr("expected"));
  EXPECT_THAT(WhyNot("step", {{"to", "moon"}}), HasSubstr("\"moon\""));
  EXPECT_THAT(WhyNot("continue", {{"result", "IDLE"}}), HasSubstr("expected one of"));
  EXPECT_THAT(WhyNot("write", {{"value", 1}}), HasSubstr("key 'key' not found"));
  EXPECT_THAT(WhyNot("write", {{"key", "number"}}), HasSubstr("key 'value' not found"));
}

TEST_F(ExtensionRequestTest, WritesValues) {
  EXPECT_EQ(Run("write", {{"scope", "inner"}, {"key", "literal"}, {"value", 9}}), Json::object());
  Tick();
  const auto& layout = executor_.program().layout;
  EXPECT_EQ(executor_.blackboard()[layout.Find(ScopeIndex{1}, "literal")].value.Print(), "9");
}

TEST_F(ExtensionRequestTest, PausesForTheClientThatAsked) {
  EXPECT_EQ(Run("pause"), Json::object());
  EXPECT_TRUE(tree_->debugger().is_pausing());
  tree_->debugger().Release(session_.owner + 1);
  EXPECT_TRUE(tree_->debugger().is_pausing());
  Run("continue");
  EXPECT_FALSE(tree_->debugger().is_pausing());
  Run("step");
  tree_->debugger().Release(session_.owner);
  EXPECT_FALSE(tree_->debugger().is_pausing());
}

TEST_F(ExtensionRequestTest, NeedsTheRoleToControl) {
  may_control_ = false;
  for (const char* what : {"pause", "step", "continue", "hook", "unhook", "enable", "write"}) {
    try {
      Run(what);
      ADD_FAILURE() << what;
    } catch (const RequestError& error) {
      EXPECT_EQ(error.kind, RequestError::Kind::kRole) << what;
    }
  }
  for (const char* what : {"trees", "ping", "subscribe", "statistics", "hooks"}) {
    EXPECT_EQ(WhyNot(what), "");
  }
}

class MovingRobotTest : public ExtensionRequestTest {
 protected:
  MovingRobotTest() : ExtensionRequestTest(Moving()) {}
};

TEST_F(MovingRobotTest, RefusesWhatWouldDisturbIt) {
  for (const char* what : {"pause", "step", "hook", "write"}) {
    EXPECT_EQ(WhyNot(what), "the robot moves") << what;
  }
  EXPECT_EQ(WhyNot("continue", {{"result", "FAILURE"}}), "the robot moves");
  EXPECT_EQ(WhyNot("continue"), "");
  EXPECT_EQ(WhyNot("unhook"), "");
}

class WatchedRobotTest : public ExtensionRequestTest {
 protected:
  WatchedRobotTest() : ExtensionRequestTest(ReadOnly()) {}
};

TEST_F(WatchedRobotTest, RefusesAllControl) {
  for (const char* what : {"pause", "step", "hook", "write", "continue", "unhook", "enable"}) {
    EXPECT_THAT(WhyNot(what), HasSubstr("read-only")) << what;
  }
}

}  // namespace
}  // namespace coppice
