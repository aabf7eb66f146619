#include "bt_core/live/groot2/groot2_service.h"

#include "tests/bt_core/live/desk_fixture.h"

namespace coppice {
namespace {

using groot2::Parts;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr const char* kFailSecond =
    R"({"enabled": true, "uid": 2, "mode": 1, "once": false, "desired_status": "FAILURE",
        "position": 0})";

class Groot2ServiceTest : public LiveTreeFixture {
 protected:
  using LiveTreeFixture::LiveTreeFixture;

  Parts Ask(char type, const std::string& argument = {}, bool may_control = true) {
    const groot2::Request request{static_cast<groot2::RequestType>(type), 5, argument};
    return service_.Answer(request, may_control, now_);
  }

  Duration now_{1s};
  Groot2Service service_{tree_, 5s};
};

TEST_F(Groot2ServiceTest, AnswersWithAPayloadWhereThereIsOne) {
  Tick();
  for (const char type : std::string("TSDt")) EXPECT_THAT(Ask(type), SizeIs(2)) << type;
  EXPECT_THAT(Ask('B', "Main"), SizeIs(2));
  EXPECT_THAT(Ask('r', "start"), SizeIs(2));
  for (const char type : std::string("AX")) EXPECT_THAT(Ask(type), SizeIs(1)) << type;
  EXPECT_THAT(Ask('I', kFailSecond), SizeIs(1));
  EXPECT_THAT(Ask('r', "stop"), SizeIs(1));
  EXPECT_THAT(Ask('r', "anything"), SizeIs(1));
}

TEST_F(Groot2ServiceTest, BearsTheIdentityOfTheTree) {
  const groot2::TreeId id = tree_->id();
  EXPECT_EQ(Ask('S')[0].substr(6), std::string(id.begin(), id.end()));
}

TEST_F(Groot2ServiceTest, SaysWhatIsWrongInTheWordsOfTheProtocol) {
  EXPECT_THAT(Ask('I', "{"), ElementsAre("error", HasSubstr("[json.exception.parse_error.101]")));
  EXPECT_THAT(Ask('R', "{}"), ElementsAre("error", HasSubstr("key 'uid' not found")));
  EXPECT_THAT(Ask('R', R"({"uid": 1, "position": 0})"), ElementsAre("error", "Node ID not found"));
}

TEST_F(Groot2ServiceTest, LetsReadersWatchButNotControl) {
  for (const char type : std::string("IRUAXrt")) {
    EXPECT_THAT(Ask(type, kFailSecond, false), ElementsAre("error", HasSubstr("not control")));
  }
  for (const char type : std::string("TSD")) EXPECT_THAT(Ask(type, {}, false), SizeIs(2));
}

TEST_F(Groot2ServiceTest, DisablesHooksWhenNobodyAsksAndEnablesThemWhenSomebodyDoes) {
  Ask('I', kFailSecond);
  now_ += 4s;
  service_.Expire(now_);
  EXPECT_TRUE(tree_->debugger().hooks()[0].hook.enabled);
  now_ += 1s;
  service_.Expire(now_);
  EXPECT_FALSE(tree_->debugger().hooks()[0].hook.enabled);
  Ask('S');
  EXPECT_TRUE(tree_->debugger().hooks()[0].hook.enabled);
  service_.Expire(now_ + 4s);
  EXPECT_TRUE(tree_->debugger().hooks()[0].hook.enabled);
}

TEST_F(Groot2ServiceTest, AReaderBringsBackNoHookWhoseOwnerIsSilent) {
  Ask('I', kFailSecond);
  service_.Expire(now_ += 5s);
  Ask('S', {}, false);
  EXPECT_FALSE(tree_->debugger().hooks()[0].hook.enabled);
}

TEST_F(Groot2ServiceTest, PublishesTheNodeOfAHookThatActed) {
  Ask('I', kFailSecond);
  Tick();
  const std::vector<DebugEvent> events = tree_->TakeDebugEvents();
  ASSERT_THAT(events, SizeIs(1));
  const Parts notification = service_.Notification(events[0]);
  ASSERT_THAT(notification, SizeIs(2));
  EXPECT_EQ(notification[0].substr(0, 2), "\x02N");
  EXPECT_EQ(notification[0].size(), 6u);
  EXPECT_EQ(notification[1], "2");
  DebugEvent of_another = events[0];
  ++of_another.stop.hook;
  EXPECT_THAT(service_.Notification(of_another), SizeIs(0));
}

TEST(Groot2Service, SaysWhyARobotRefuses) {
  struct Test : Groot2ServiceTest {
    Test() : Groot2ServiceTest(Moving()) {}
    void TestBody() override {
      EXPECT_THAT(Ask('I', kFailSecond), ElementsAre("error", "the robot moves"));
    }
  };
  Test().TestBody();
}

}  // namespace
}  // namespace coppice
