#include "editor/live/live_client.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "tests/editor/live/fake_robot.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] =
    "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\" _fullpath=\"\">"
    "<Sequence name=\"top\" _uid=\"1\"><Go name=\"Go\" "
    "_uid=\"2\"/></Sequence></BehaviorTree></root>";
constexpr char kOtherTree[] =
    "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Other\" _fullpath=\"\">"
    "<Fallback name=\"top\" _uid=\"1\"/></BehaviorTree></root>";

LiveClientOptions Quick() {
  LiveClientOptions options;
  options.status_period = std::chrono::milliseconds(5);
  options.board_period = std::chrono::milliseconds(10);
  options.reply_timeout = std::chrono::milliseconds(150);
  options.first_pause = std::chrono::milliseconds(10);
  options.longest_pause = std::chrono::milliseconds(40);
  return options;
}

// A client and a way to wait for what it says.
class Follower {
 public:
  explicit Follower(const std::string& endpoint)
      : client_(
            endpoint, clock_, [this] { Note(); }, Quick()) {}

  // True if the snapshot fulfils the condition within ten seconds.
  template <class Condition>
  bool Sees(Condition condition) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(10),
                             [&] { return condition(*client_.snapshot()); });
  }
  bool SeesLive() {
    return Sees([](const LiveSnapshot& s) { return s.connection == Connection::kLive; });
  }
  LiveClient& client() { return client_; }

 private:
  void Note() {
    const std::lock_guard<std::mutex> lock(mutex_);
    changed_.notify_all();
  }

  WallClock clock_;
  std::mutex mutex_;
  std::condition_variable changed_;
  LiveClient client_;  // last: its thread calls Note()
};

TEST(LiveClient, ReadsTreeStatusesAndTimes) {
  FakeRobot robot(kTree);
  Follower follower(robot.endpoint());
  ASSERT_TRUE(follower.Sees([](const LiveSnapshot& s) { return s.states.size() == 3; }));
  const auto snapshot = follower.client().snapshot();
  EXPECT_EQ(snapshot->connection, Connection::kLive);
  EXPECT_EQ(snapshot->tree->forest.trees()[0].id, "Main");
  EXPECT_EQ(snapshot->states[1].status, Status::kRunning);
  EXPECT_EQ(snapshot->states[2].status, Status::kIdle);
  EXPECT_EQ(snapshot->states[2].before, Status::kSuccess);
  EXPECT_GT(snapshot->round_trip, Duration(0));
  EXPECT_EQ(snapshot->sessions, 1);
  EXPECT_EQ(robot.requests('T'), 1) << "the tree is asked for once";
}

TEST(LiveClient, RemembersWhenAStatusCame) {
  FakeRobot robot(kTree);
  Follower follower(robot.endpoint());
  ASSERT_TRUE(follower.Sees([](const LiveSnapshot& s) { return s.states.size() == 3; }));
  const Time since = follower.client().snapshot()->states[1].since;
  robot.SetStatuses(std::string("\x01\x00\x01\x02\x00\x03", 6));
  ASSERT_TRUE(
      follower.Sees([](const LiveSnapshot& s) { return s.states[2].status == Status::kFailure; }));
  const auto snapshot = follower.client().snapshot();
  EXPECT_EQ(snapshot->states[1].since, since);
  EXPECT_GT(snapshot->states[2].since, since);
}

TEST(LiveClient, AsksForTheWatchedBoardsOnly) {
  FakeRobot robot(kTree);
  Follower follower(robot.endpoint());
  ASSERT_TRUE(follower.SeesLive());
  EXPECT_EQ(robot.requests('B'), 0);
  follower.client().Watch({"Main", "walk"});
  ASSERT_TRUE(follower.Sees([](const LiveSnapshot& s) { return !s.boards.empty(); }));
  EXPECT_EQ(robot.last_boards(), "Main;walk");
  const auto boards = follower.client().snapshot()->boards;
  ASSERT_EQ(boards[0].entries.size(), 2U);
  EXPECT_EQ(boards[0].entries[0].key, "goal");
  EXPECT_EQ(boards[0].entries[0].value, "\"kitchen\"");
  EXPECT_EQ(boards[0].entries[1].value, "7");
}

TEST(LiveClient, TakesTheNewTreeWhenTheRobotSwapsIt) {
  FakeRobot robot(kTree, 'a');
  Follower follower(robot.endpoint());
  ASSERT_TRUE(follower.SeesLive());
  robot.SwapTree(kOtherTree, 'b');
  ASSERT_TRUE(follower.Sees([](const LiveSnapshot& s) { return s.sessions == 2; }));
  EXPECT_EQ(follower.client().snapshot()->tree->forest.trees()[0].id, "Other");
}

TEST(LiveClient, KeepsTheLastTreeWhileTheRobotIsDownAndComesBack) {
  auto robot = std::make_unique<FakeRobot>(kTree, 'a');
  const int port = robot->port();
  Follower follower(robot->endpoint());
  ASSERT_TRUE(follower.SeesLive());
  robot.reset();
  ASSERT_TRUE(follower.Sees(
      [](const LiveSnapshot& s) { return s.connection == Connection::kReconnecting; }));
  const auto down = follower.client().snapshot();
  EXPECT_NE(down->tree, nullptr);
  EXPECT_NE(down->error.find("no answer"), std::string::npos) << down->error;
  EXPECT_GT(down->next_try, Time(0));

  FakeRobot again(kOtherTree, 'b', port);
  ASSERT_TRUE(follower.Sees(
      [](const LiveSnapshot& s) { return s.connection == Connection::kLive && s.sessions == 2; }));
  EXPECT_EQ(follower.client().snapshot()->error, "");
}

TEST(LiveClient, FindsARobotThatStartsLater) {
  int port = 0;
  { port = FakeRobot(kTree).port(); }
  Follower follower("127.0.0.1:" + std::to_string(port));
  ASSERT_TRUE(follower.Sees(
      [](const LiveSnapshot& s) { return s.connection == Connection::kReconnecting; }));
  FakeRobot robot(kTree, 'a', port);
  EXPECT_TRUE(follower.SeesLive());
}

class LiveClientNonsense : public testing::TestWithParam<FakeRobot::Mood> {};

TEST_P(LiveClientNonsense, IsReportedAndSurvived) {
  FakeRobot robot(kTree);
  robot.mood = GetParam();
  Follower follower(robot.endpoint());
  ASSERT_TRUE(follower.Sees([](const LiveSnapshot& s) {
    return s.connection == Connection::kReconnecting && !s.error.empty();
  }));
  robot.mood = FakeRobot::Mood::kGood;
  EXPECT_TRUE(follower.SeesLive());
}

INSTANTIATE_TEST_SUITE_P(All, LiveClientNonsense,
                         testing::Values(FakeRobot::Mood::kGarbage, FakeRobot::Mood::kShortHeader,
                                         FakeRobot::Mood::kWrongNumber, FakeRobot::Mood::kError,
                                         FakeRobot::Mood::kBadStatus, FakeRobot::Mood::kBadTree,
                                         FakeRobot::Mood::kMute));

TEST(LiveClient, EndsAtOnceWhileItWaitsForAnAnswer) {
  LiveClientOptions patient;
  patient.reply_timeout = std::chrono::hours(1);
  const WallClock clock;
  FakeRobot robot(kTree);
  robot.mood = FakeRobot::Mood::kMute;
  const Time start = clock.Now();
  { LiveClient client(robot.endpoint(), clock, {}, patient); }
  EXPECT_LT(clock.Now() - start, std::chrono::seconds(5));
}

TEST(LiveClient, ReportsAnEndpointThatIsNone) {
  Follower follower("no such host!:x");
  EXPECT_TRUE(follower.Sees(
      [](const LiveSnapshot& s) { return s.error.find("cannot connect") != std::string::npos; }));
}

TEST(LiveClient, FollowsTwoRobotsAtOnce) {
  FakeRobot application(kTree, 'a');
  FakeRobot monitor(kOtherTree, 'b');
  Follower first(application.endpoint());
  Follower second(monitor.endpoint());
  EXPECT_TRUE(first.SeesLive());
  EXPECT_TRUE(second.SeesLive());
  EXPECT_EQ(first.client().snapshot()->tree->forest.trees()[0].id, "Main");
  EXPECT_EQ(second.client().snapshot()->tree->forest.trees()[0].id, "Other");
}

}  // namespace
}  // namespace coppice::editor
