#include "bt_core/live/server/extension_service.h"

#include "tests/bt_core/live/desk_fixture.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class ExtensionServiceTest : public LiveTreeFixture {
 protected:
  Json Ask(const std::string& request, bool may_control = true) {
    last_ = service_.Serve(kAnn, may_control, request, 1s);
    return Json::parse(last_.json);
  }

  LiveTrees trees_{{0, tree_}};
  LiveSessions sessions_{trees_};
  ExtensionService service_{trees_, sessions_, 5s};
  ExtensionService::Answer last_;
};

TEST_F(ExtensionServiceTest, GreetsWithWhatTheClientMayDo) {
  Json hello = Ask(R"({"do": "hello", "name": "me"})");
  EXPECT_EQ(hello["protocol"], 1);
  EXPECT_EQ(hello["role"], "control");
  EXPECT_EQ(hello["control"], true);
  EXPECT_EQ(hello["deadline_ms"], 5000);
  EXPECT_EQ(hello["trees"].size(), 1u);
  EXPECT_EQ(sessions_.Find(kAnn)->name, "me");
  hello = Ask(R"({"do": "hello"})", false);
  EXPECT_EQ(hello["role"], "read");
  EXPECT_THAT(hello["control"].get<std::string>(), HasSubstr("not control"));
}

TEST_F(ExtensionServiceTest, WantsToBeGreetedFirst) {
  EXPECT_EQ(Ask(R"({"do": "ping"})")["error"], "say hello first");
  EXPECT_TRUE(last_.failed);
  Ask(R"({"do": "hello"})");
  EXPECT_EQ(Ask(R"({"do": "ping"})"), Json::object());
  EXPECT_FALSE(last_.failed);
  EXPECT_EQ(Ask(R"({"do": "bye"})"), Json::object());
  EXPECT_EQ(Ask(R"({"do": "ping"})")["error"], "say hello first");
}

TEST_F(ExtensionServiceTest, SaysWhatIsWrongAndWhy) {
  EXPECT_THAT(Ask("{")["error"].get<std::string>(), HasSubstr("parse error"));
  EXPECT_THAT(Ask("[]")["error"].get<std::string>(), HasSubstr("cannot use at() with array"));
  EXPECT_THAT(Ask("{\"do\": 5}")["error"].get<std::string>(), HasSubstr("must be string"));
  EXPECT_THAT(Ask("\"\xff\"")["error"].get<std::string>(), HasSubstr("UTF-8"));
  Ask(R"({"do": "hello"})", false);
  EXPECT_EQ(Ask(R"({"do": "pause"})", false)["role"], "control");
}

TEST_F(ExtensionServiceTest, DescribesWhatTheDebuggerTells) {
  DebugEvent event;
  event.stop = {DebugStop::Where::kBefore, NodeIndex{5}, Status::kIdle, HookId{2}, 9};
  Json notice = Json::parse(service_.Describe(0, event));
  EXPECT_EQ(notice["event"], "stopped");
  EXPECT_EQ(notice["stop"]["path"], "last");
  event.kind = DebugEvent::Kind::kResumed;
  EXPECT_EQ(Json::parse(service_.Describe(0, event)),
            Json::parse(R"({"event": "resumed", "tree": 0})"));
  event.kind = DebugEvent::Kind::kRefused;
  event.reason = "the robot moves";
  EXPECT_EQ(Json::parse(service_.Describe(0, event))["text"], "the robot moves");
  event.kind = DebugEvent::Kind::kReplaced;
  EXPECT_EQ(Json::parse(service_.Describe(0, event))["event"], "replaced");
  EXPECT_EQ(Json::parse(service_.DescribeTrees())["trees"].size(), 1u);
  EXPECT_THAT(service_.DescribeRelease(), HasSubstr("5000 ms"));
}

}  // namespace
}  // namespace coppice
