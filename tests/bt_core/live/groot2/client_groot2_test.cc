#include "bt_core/live/groot2/client_groot2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "bt_core/data/value_bytes.h"
#include "bt_core/live/groot2/groot2_hook_json.h"
#include "tests/bt_core/live/live_client.h"
#include "tests/bt_core/live/robot.h"
#include "tests/bt_core/live/watcher.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Kind = LiveCommand::Kind;

LiveClientOptions Groot2Only() {
  LiveClientOptions options;
  options.groot2_only = true;
  options.poll_period = 5ms;
  options.board_period = 5ms;
  return options;
}

bool IsLive(const Watched& watched) { return watched.is_live(); }

// Whether the statuses are those that the robot has now; its tree must stand still.
auto Agrees(Robot& robot) {
  return [statuses = robot.executor().statuses()](const Watched& w) {
    return w.follower && w.follower->statuses() == statuses;
  };
}

TEST(ClientGroot2, FollowsTheTreeByItsTransitions) {
  Robot robot;
  robot.Tick();
  Watcher watcher;
  const LiveClient client(robot.endpoint(), watcher, Groot2Only());
  ASSERT_TRUE(watcher.Await(IsLive));
  EXPECT_EQ(watcher.watched().connections.back().protocol, LiveConnection::Protocol::kGroot2);
  ASSERT_EQ(watcher.watched().trees[0].nodes.size(), robot.executor().program().nodes.size());
  for (int i = 0; i < 20; ++i) {
    robot.Tick();
    ASSERT_TRUE(watcher.Await(Agrees(robot)));
  }
  EXPECT_THAT(watcher.watched().gaps, IsEmpty());
}

TEST(ClientGroot2, GetsTransitionsBetweenTwoPolls) {
  Robot robot;
  Watcher watcher;
  LiveClientOptions options = Groot2Only();
  options.poll_period = 300ms;
  const LiveClient client(robot.endpoint(), watcher, options);
  ASSERT_TRUE(watcher.Await(IsLive));
  robot.Tick(10);  // 10 ms apart in the tree's clock
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.ticks.size() >= 10; }));
}

TEST(ClientGroot2, BringsTheBlackboard) {
  Robot robot;
  Watcher watcher;
  const LiveClient client(robot.endpoint(), watcher, Groot2Only());
  ASSERT_TRUE(watcher.Await(IsLive));
  robot.Tick(7);
  ASSERT_TRUE(watcher.Await([](const Watched& w) {
    for (SlotIndex i{0}; i < w.values.size(); ++i) {
      const DescribedSlot& slot = w.trees.back().slots[i];
      if (slot.name == "number") return PrintValueBytes(w.values[i]) == "7";
    }
    return false;
  }));
}

TEST(ClientGroot2, StopsAtABreakpointAndContinues) {
  Robot robot;
  robot.StartTicking();
  Watcher watcher;
  LiveClient client(robot.endpoint(), watcher, Groot2Only());
  ASSERT_TRUE(watcher.Await(IsLive));
  EXPECT_NE(Ask(client, MakeCommand(Kind::kContinue)).problem(), "");
  Hook hook;
  hook.path = "inner/Alternate";
  const LiveReply reply = Ask(client, SetHook(hook));
  ASSERT_EQ(reply.problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.notices.empty(); }));
  EXPECT_EQ(watcher.watched().notices[0].event.stop.hook, reply->id);
  EXPECT_THAT(watcher.watched().notices[0].path, HasSubstr("inner/Alternate"));
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kContinue)).problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.notices.size() > 1; }));
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kRemoveHook)).problem(), "");
}

TEST(ClientGroot2, ForcesAResult) {
  Robot robot;
  Watcher watcher;
  LiveClient client(robot.endpoint(), watcher, Groot2Only());
  ASSERT_TRUE(watcher.Await(IsLive));
  Hook hook;
  hook.path = "Fill";
  hook.action = HookAction::kReplace;
  hook.status = Status::kFailure;
  ASSERT_EQ(Ask(client, SetHook(hook)).problem(), "");
  EXPECT_EQ(robot.executor().Tick(), Status::kFailure);
  robot.StartTicking();  // a subscriber hears what happens after it has come
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.notices.empty(); }));
  EXPECT_EQ(watcher.watched().notices[0].event.kind, DebugEvent::Kind::kReplaced);
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kRemoveHook)).problem(), "");
  robot.StopTicking();
  EXPECT_EQ(robot.executor().Tick(), Status::kRunning);
}

class ForeignHookTest : public ::testing::Test {
 protected:
  // Somebody has left a breakpoint at the leaf "Fill", which stops the tree.
  void SetUp() override {
    PlainClient other(robot_.port());
    other.Ask({PlainClient::Header('I'), groot2::WriteHookInsert(Hook(), 2)});
    robot_.StartTicking();
    ASSERT_TRUE(watcher_.Await(IsLive));
    ASSERT_TRUE(watcher_.Await([](const Watched& w) { return w.foreign_hooks.size() == 1; }));
  }

  Robot robot_;
  Watcher watcher_;
  LiveClient client_{robot_.endpoint(), watcher_, Groot2Only()};
};

TEST_F(ForeignHookTest, IsListed) {
  const ForeignHook foreign = watcher_.watched().foreign_hooks[0];
  EXPECT_EQ(foreign.hook.path, "Fill::2");
  EXPECT_EQ(ToString(foreign.hook), "before");
}

TEST_F(ForeignHookTest, IsRemovedAsItWereOnesOwn) {
  LiveCommand remove = MakeCommand(Kind::kRemoveHook);
  remove.id = watcher_.watched().foreign_hooks[0].id;
  EXPECT_EQ(Ask(client_, remove).problem(), "");
  ASSERT_TRUE(watcher_.Await([](const Watched& w) { return w.foreign_hooks.empty(); }));
  EXPECT_TRUE(watcher_.Await([](const Watched& w) { return w.ticks.size() > 3; }));
}

TEST_F(ForeignHookTest, ATreeGoesOnThatStoodThereBeforeTheClientCame) {
  EXPECT_EQ(Ask(client_, MakeCommand(Kind::kContinue)).problem(), "");
  EXPECT_TRUE(watcher_.Await([](const Watched& w) { return !w.notices.empty(); }))
      << "it stops there again";
}

TEST(ClientGroot2, SaysWhatTheProtocolCannotDo) {
  Robot robot;
  Watcher watcher;
  LiveClient client(robot.endpoint(), watcher, Groot2Only());
  ASSERT_TRUE(watcher.Await(IsLive));
  EXPECT_THAT(Ask(client, MakeCommand(Kind::kPause)).problem(), HasSubstr("cannot pause"));
  EXPECT_THAT(Ask(client, WriteKey("", "number", "1")).problem(), HasSubstr("cannot be set"));
  Hook hook;
  hook.path = "Fill";
  hook.condition = "true";
  EXPECT_THAT(Ask(client, SetHook(hook)).problem(), HasSubstr("no conditions"));
  hook = Hook();
  hook.path = "Missing";
  EXPECT_THAT(Ask(client, SetHook(hook)).problem(), HasSubstr(R"(no node is called "Missing")"));
  LiveCommand remove = MakeCommand(Kind::kRemoveHook);
  remove.id = HookId{99};
  EXPECT_THAT(Ask(client, remove).problem(), HasSubstr("no hook 99"));
}

TEST(ClientGroot2, BeginsAnewWhenTheRobotIsAnotherOne) {
  auto robot = std::make_unique<Robot>();
  const std::uint16_t port = robot->port();
  Watcher watcher;
  const LiveClient client(robot->endpoint(), watcher, Groot2Only());
  ASSERT_TRUE(watcher.Await(IsLive));
  robot.reset();
  robot = std::make_unique<Robot>(Robot::WithPort(port));
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.trees.size() >= 2; }));
  ASSERT_TRUE(watcher.Await(IsLive));
  robot->Tick(3);
  ASSERT_TRUE(watcher.Await(Agrees(*robot)));
}

// The robot's side is the test.
class ClientGroot2SessionTest : public ::testing::Test {
 protected:
  static constexpr char kTree[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main" _fullpath="">
    <AlwaysSuccess name="a" _uid="1"/></BehaviorTree></root>)";

  // Answers the request that was sent last, as a robot with the tree of this number.
  void Answer(const std::string& payload, char run = 'a') {
    session_.OnMessage({sent_.back()[0] + std::string(16, run), payload}, 1s);
  }
  void Connect() {
    session_.OnTime(1s);
    const std::string idle = {1, 0, 0};
    for (const std::string& payload :
         {idle, std::string(kTree), std::string("\x80"), hooks_, std::string("1000000"), idle}) {
      Answer(payload);
      session_.OnTime(1s);
    }
    ASSERT_TRUE(session_.is_live());
  }

  std::string hooks_ = "[]";  // of others, when the session begins
  LiveClientOptions options_ = Groot2Only();
  Watcher watcher_;
  Groot2History history_{watcher_, "robot"};
  std::vector<ClientSession::Parts> sent_;
  ClientGroot2 session_{options_, watcher_, history_,
                        [this](const ClientSession::Parts& parts) { sent_.push_back(parts); }};
};

TEST_F(ClientGroot2SessionTest, ACommandIsAnsweredAlsoWhenTheRobotIsAnotherOne) {
  Connect();
  Answer("");                      // transitions
  Answer(std::string({1, 0, 0}));  // statuses
  Answer("\x80");                  // values
  Answer("[]");                    // hooks
  Hook hook;
  hook.path = "a";
  std::vector<std::string> errors;
  session_.Send(SetHook(hook), [&](const LiveReply& reply) { errors.push_back(reply.problem()); });
  session_.OnTime(1s);
  ASSERT_EQ(sent_.back()[0][1], 'I');
  Answer("", 'b');
  EXPECT_THAT(errors, ElementsAre("the robot runs another tree"));
  session_.OnTime(1s);
  EXPECT_EQ(sent_.back()[0][1], 'T');
}

TEST_F(ClientGroot2SessionTest, TakesItsHooksAwayWhenItLeavesAlsoOneThatIsUnderWay) {
  Connect();
  Answer("");                      // transitions
  Answer(std::string({1, 0, 0}));  // statuses
  Answer("\x80");                  // values
  Answer("[]");                    // hooks
  Hook hook;
  hook.path = "a";
  session_.Send(SetHook(hook), {});
  session_.OnTime(1s);
  Answer("");
  hook.position = HookPosition::kAfter;
  session_.Send(SetHook(hook), {});
  session_.OnTime(1s);
  sent_.clear();
  session_.Abandon("the client ends");
  session_.Leave();
  ASSERT_THAT(sent_, SizeIs(2));
  EXPECT_EQ(sent_[0][0][1], 'R');
  EXPECT_THAT(sent_[0][1], HasSubstr("\"position\":0"));
  EXPECT_THAT(sent_[1][1], HasSubstr("\"position\":1"));
}

TEST_F(ClientGroot2SessionTest, LeavesTheHooksOfOthersWhereTheyAre) {
  hooks_ = groot2::WriteHookInsert(Hook(), 1);
  hooks_ = "[" + hooks_ + "]";
  Connect();
  ASSERT_THAT(watcher_.watched().foreign_hooks, SizeIs(1));
  sent_.clear();
  session_.Leave();
  EXPECT_THAT(sent_, IsEmpty());
}

TEST_F(ClientGroot2SessionTest, HandsOnNoNoticeBeforeTheTree) {
  session_.OnTime(1s);
  EXPECT_FALSE(session_.has_answered());
  Answer(std::string({1, 0, 0}));
  EXPECT_TRUE(session_.has_answered());
  session_.OnTime(1s);
  Answer(kTree);
  session_.OnMessage({std::string("\2N\0\0\0\0", 6), "1"}, 1s);
  EXPECT_THAT(watcher_.watched().notices, IsEmpty());
}

}  // namespace
}  // namespace coppice
