#include "bt_core/live/client/client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "bt_core/data/value_bytes.h"
#include "bt_core/live/pictures/live_pictures.h"
#include "tests/bt_core/live/cut_line.h"
#include "tests/bt_core/live/robot.h"
#include "tests/bt_core/live/watcher.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Kind = LiveCommand::Kind;

std::vector<std::uint64_t> UpTo(std::uint64_t last) {
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t i = 1; i <= last; ++i) numbers.push_back(i);
  return numbers;
}

auto HasTick(std::uint64_t tick) {
  return [tick](const Watched& w) { return w.last_tick() >= tick; };
}

bool IsLive(const Watched& watched) { return watched.is_live(); }

Hook At(const std::string& path, HookAction action = HookAction::kStop) {
  Hook hook;
  hook.path = path;
  hook.action = action;
  return hook;
}

TEST(LiveClient, GetsEveryTickFromTheBeginning) {
  Robot robot;
  robot.Tick(100);
  Watcher watcher;
  const LiveClient client(robot.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(HasTick(100)));
  robot.Tick(50);
  ASSERT_TRUE(watcher.Await(HasTick(150)));
  const Watched watched = watcher.watched();
  EXPECT_EQ(watched.ticks, UpTo(150));
  EXPECT_EQ(watched.follower->statuses(), robot.executor().statuses());
  EXPECT_THAT(watched.gaps, IsEmpty());
  EXPECT_EQ(watched.trees.size(), 1u);
  EXPECT_EQ(watched.connections.back().protocol, LiveConnection::Protocol::kCoppice);
  EXPECT_THAT(watched.connections.back().trees, ElementsAre("Main"));
}

TEST(LiveClient, BeginsWithThePresentIfThePastIsNotWanted) {
  Robot robot;
  robot.Tick(30000);
  Watcher watcher;
  LiveClientOptions options;
  options.with_past = false;
  const LiveClient client(robot.endpoint(), watcher, options);
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.states.empty(); }));
  robot.Tick();
  ASSERT_TRUE(watcher.Await(HasTick(30001)));
  EXPECT_LT(watcher.watched().ticks.size(), 30000u);
  EXPECT_EQ(watcher.watched().follower->statuses(), robot.executor().statuses());
}

TEST(LiveClient, WaitsForARobotThatIsNotThereYet) {
  std::uint16_t port = 0;
  { port = Robot().port(); }
  Watcher watcher;
  LiveClient client("127.0.0.1:" + std::to_string(port), watcher);
  EXPECT_THAT(Ask(client, MakeCommand(Kind::kPause)).problem(),
              HasSubstr("not connected to 127.0.0.1"));
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.connections.empty(); }));
  EXPECT_THAT(watcher.watched().connections[0].problem, HasSubstr("no answer from"));
  Robot robot(Robot::WithPort(port));
  robot.Tick(3);
  ASSERT_TRUE(watcher.Await(HasTick(3)));
}

TEST(LiveClient, IsBackWithinASecondAfterEachRestartOfTheRobot) {
  auto robot = std::make_unique<Robot>();
  const std::uint16_t port = robot->port();
  Watcher watcher;
  const LiveClient client(robot->endpoint(), watcher);
  for (int restarts = 1; restarts <= 20; ++restarts) {
    robot->Tick(5);
    ASSERT_TRUE(watcher.Await(HasTick(5)));
    robot.reset();
    ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.is_live(); }));
    robot = std::make_unique<Robot>(Robot::WithPort(port));
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(watcher.Await(IsLive));
    EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
    ASSERT_TRUE(watcher.Await([restarts](const Watched& w) {
      return w.trees.size() > static_cast<std::size_t>(restarts);
    }));
  }
  EXPECT_THAT(watcher.watched().gaps, IsEmpty());
  EXPECT_EQ(watcher.watched().ends, 20u);  // every run ended in order
}

TEST(LiveClient, GoesOnWhereItWasWhenTheLineWasCut) {
  Robot robot;
  CutLine line(robot.port());
  Watcher watcher;
  const LiveClient client(line.endpoint(), watcher);
  robot.Tick(10);
  ASSERT_TRUE(watcher.Await(HasTick(10)));
  line.Cut();
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.is_live(); }));
  robot.Tick(1000);
  line.Mend();
  ASSERT_TRUE(watcher.Await(HasTick(1010)));
  const Watched watched = watcher.watched();
  EXPECT_EQ(watched.ticks, UpTo(1010));
  EXPECT_THAT(watched.gaps, IsEmpty());
  EXPECT_EQ(watched.trees.size(), 1u);
  EXPECT_EQ(watched.follower->statuses(), robot.executor().statuses());
}

TEST(LiveClient, ReportsWhatTheRobotHasNotKeptWhileTheLineWasCut) {
  LiveOptions options = Robot::WithPort(0);
  options.history_bytes = 1000;
  Robot robot(options);
  CutLine line(robot.port());
  Watcher watcher;
  const LiveClient client(line.endpoint(), watcher);
  robot.Tick(10);
  ASSERT_TRUE(watcher.Await(HasTick(10)));
  line.Cut();
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.is_live(); }));
  robot.Tick(20000);
  line.Mend();
  ASSERT_TRUE(watcher.Await(HasTick(20010)));
  const Watched watched = watcher.watched();
  ASSERT_FALSE(watched.gaps.empty());
  const bool tells_all = watched.gaps[0].first_tick == 1;
  std::uint64_t lost = tells_all ? 0 : watched.states[0].tick;  // before the client was there
  for (const HistoryGap& gap : watched.gaps) lost += gap.lost_ticks;
  EXPECT_EQ(lost + watched.ticks.size(), 20010u);
  EXPECT_EQ(watched.follower->statuses(), robot.executor().statuses());
}

TEST(LiveClient, StopsStepsAndContinuesTheTree) {
  Robot robot;
  robot.StartTicking();
  Watcher watcher;
  LiveClient client(robot.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(IsLive));
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kPause)).problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.notices.size() == 1; }));
  EXPECT_EQ(watcher.watched().notices[0].event.stop.where, DebugStop::Where::kBetweenTicks);
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kStepNode)).problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.notices.size() == 3; }));
  EXPECT_EQ(watcher.watched().notices[2].path, "top & first");
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kStepTick)).problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.notices.size() == 5; }));
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kContinue)).problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.notices.size() == 6; }));
  EXPECT_EQ(watcher.watched().notices[5].event.kind, DebugEvent::Kind::kResumed);
}

TEST(LiveClient, StopsAtABreakpointWithAConditionAndSaysWhatIsWrongWithOne) {
  Robot robot;
  robot.StartTicking();
  Watcher watcher;
  LiveClient client(robot.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(IsLive));
  Hook hook = At("inner/Alternate");
  hook.condition = "sayd == 'x'";
  EXPECT_THAT(Ask(client, SetHook(hook)).problem(), HasSubstr(R"(did you mean "said"?)"));
  EXPECT_THAT(Ask(client, SetHook(At("nowhere")))->remark, HasSubstr(R"(no node "nowhere")"));
  hook.condition = "@number > 5";
  const LiveReply reply = Ask(client, SetHook(hook));
  EXPECT_EQ(reply.problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.notices.empty(); }));
  const LiveNotice stop = watcher.watched().notices[0];
  EXPECT_EQ(stop.path, "inner/Alternate::5");
  EXPECT_EQ(stop.event.stop.hook, reply->id);
  LiveCommand remove = MakeCommand(Kind::kRemoveHook);
  remove.id = reply->id;
  EXPECT_EQ(Ask(client, remove).problem(), "");
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return w.notices.size() == 2; }));
}

TEST(LiveClient, ForcesResultsAndWritesValues) {
  Robot robot;
  Watcher watcher;
  LiveClient client(robot.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(IsLive));
  Hook hook = At("Fill", HookAction::kReplace);
  hook.status = Status::kFailure;
  hook.times = 2;
  ASSERT_EQ(Ask(client, SetHook(hook)).problem(), "");
  EXPECT_EQ(robot.executor().Tick(), Status::kFailure);
  EXPECT_EQ(robot.executor().Tick(), Status::kFailure);
  EXPECT_EQ(robot.executor().Tick(), Status::kRunning);
  ASSERT_EQ(Ask(client, WriteKey("", "number", "4711")).problem(), "");
  robot.Tick();
  ASSERT_TRUE(watcher.Await(HasTick(4)));
  LiveCommand json = WriteKey("", "number", "\"4712\"");
  json.is_json = true;
  EXPECT_EQ(Ask(client, json).problem(), "") << "as JSON it is a text that stands for a number";
  json.is_json = false;
  EXPECT_NE(Ask(client, json).problem(), "") << "as in the XML the quotes belong to it";
  EXPECT_THAT(Ask(client, WriteKey("", "number", "many")).problem(), HasSubstr("many"));
  EXPECT_NE(Ask(client, WriteKey("", "nubmer", "1")).problem(), "");
}

TEST(LiveClient, WhoComesWhileTheTreeStandsIsToldWhereItStands) {
  Robot robot;
  Watcher first_watcher;
  LiveClient first(robot.endpoint(), first_watcher);
  ASSERT_TRUE(first_watcher.Await(IsLive));
  ASSERT_EQ(Ask(first, SetHook(At("Fill"))).problem(), "");
  std::future<void> tick = std::async(std::launch::async, [&] { robot.Tick(); });
  const auto is_told = [](const Watched& w) {
    return !w.notices.empty() && w.notices[0].event.kind == DebugEvent::Kind::kStopped;
  };
  ASSERT_TRUE(first_watcher.Await(is_told));
  Watcher second_watcher;
  const LiveClient second(robot.endpoint(), second_watcher);
  EXPECT_TRUE(second_watcher.Await(is_told));
  EXPECT_EQ(Ask(first, MakeCommand(Kind::kContinue)).problem(), "");
  tick.get();
}

TEST(LiveClient, ReleasesWhatItOwnsWhenItEnds) {
  Robot robot;
  Watcher watcher;
  auto client = std::make_unique<LiveClient>(robot.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(IsLive));
  ASSERT_EQ(Ask(*client, SetHook(At("Fill"))).problem(), "");
  std::future<void> tick = std::async(std::launch::async, [&] { robot.Tick(); });
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.notices.empty(); }));
  client.reset();
  EXPECT_EQ(tick.wait_for(4s), std::future_status::ready);  // before the robot's deadline
}

TEST(LiveClient, ADeadClientLosesWhatItOwnsWhenTheDeadlineHasPassed) {
  LiveOptions options = Robot::WithPort(0);
  options.deadline = 300ms;
  Robot robot(options);
  CutLine line(robot.port());
  Watcher watcher;
  LiveClient client(line.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(IsLive));
  ASSERT_EQ(Ask(client, SetHook(At("Fill"))).problem(), "");
  std::future<void> tick = std::async(std::launch::async, [&] { robot.Tick(); });
  ASSERT_TRUE(watcher.Await([](const Watched& w) { return !w.notices.empty(); }));
  line.Cut();
  EXPECT_EQ(tick.wait_for(30s), std::future_status::ready);
}

TEST(LiveClient, AnswersCommandsWhenTheConnectionBreaks) {
  auto robot = std::make_unique<Robot>();
  CutLine line(robot->port());
  Watcher watcher;
  LiveClient client(line.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(IsLive));
  line.Cut();
  EXPECT_NE(Ask(client, MakeCommand(Kind::kPause)).problem(), "");
}

TEST(LiveClient, NeedsTheTokenOfTheRobot) {
  LiveOptions options = Robot::WithPort(0);
  options.token = "0123456789abcdef0123456789abcdef";
  Robot robot(options);
  robot.Tick(3);
  Watcher watcher;
  LiveClientOptions with_token;
  with_token.token = options.token;
  LiveClient client(robot.endpoint(), watcher, with_token);
  ASSERT_TRUE(watcher.Await(HasTick(3)));
  EXPECT_EQ(Ask(client, MakeCommand(Kind::kContinue)).problem(), "");

  Watcher reader;
  with_token.token = robot.live().read_token();
  LiveClient reading(robot.endpoint(), reader, with_token);
  ASSERT_TRUE(reader.Await(HasTick(3)));
  EXPECT_NE(reader.watched().connections.back().refusal, "");
  EXPECT_NE(Ask(reading, MakeCommand(Kind::kPause)).problem(), "");

  Watcher stranger;
  const LiveClient without(robot.endpoint(), stranger);
  ASSERT_TRUE(stranger.Await([](const Watched& w) { return !w.connections.empty(); }));
  EXPECT_FALSE(stranger.watched().is_live());
  with_token.token = "another token of 32 characters..";
  Watcher wrong;
  const LiveClient with_wrong(robot.endpoint(), wrong, with_token);
  ASSERT_TRUE(wrong.Await([](const Watched& w) {
    return !w.connections.empty() &&
           w.connections.back().problem.find("token") != std::string::npos;
  })) << wrong.watched().connections.back().problem;
}

TEST(LiveClient, FollowsTheTreeOfThatNameOfSeveral) {
  LiveOptions options = Robot::WithPort(0);
  SimulatedClock clock;
  Executor one(WatchedProgram(), clock);
  Executor two(CompileText(R"(<root BTCPP_format="4"><BehaviorTree ID="Second"><RunForEver/>)"
                           "</BehaviorTree></root>"),
               clock);
  EventStream first_stream(one);
  EventStream second_stream(two);
  LiveServer server(options);
  const LivePublisher first(first_stream, server);
  const LivePublisher second(second_stream, server);
  Watcher watcher;
  LiveClientOptions choice;
  choice.tree = "Second";
  const LiveClient client("127.0.0.1:" + std::to_string(server.port()), watcher, choice);
  two.Tick();
  ASSERT_TRUE(watcher.Await(HasTick(1)));
  EXPECT_EQ(watcher.watched().trees[0].main_tree, "Second");
}

TEST(LiveClient, SeesWhatTheRobotShowsToPeople) {
  const auto pictures = std::make_shared<LivePictures>();
  LiveOptions with_pictures = Robot::WithPort(0);
  with_pictures.pictures = pictures;
  const LivePicture face{"face", "SAD", 64, 32, std::vector<std::uint8_t>(6144, 7)};
  EXPECT_TRUE(pictures->Show(face));
  Robot robot(with_pictures);
  LiveClientOptions options;
  options.with_pictures = true;
  Watcher watcher, other;
  const LiveClient client(robot.endpoint(), watcher, options);
  const LiveClient uninterested(robot.endpoint(), other);
  ASSERT_TRUE(watcher.Await([&](const Watched& w) { return w.pictures == std::vector{face}; }));
  const LivePicture ears{"ears", "", 1, 1, {0, 255, 0}};
  EXPECT_TRUE(pictures->Show(ears));
  ASSERT_TRUE(watcher.Await([&](const Watched& w) {
    return w.pictures == std::vector{face, ears};
  }));
  robot.Tick();
  ASSERT_TRUE(other.Await(HasTick(1)));
  EXPECT_THAT(other.watched().pictures, IsEmpty());
}

TEST(LiveClient, RejectsWhatIsNoEndpointAndNoToken) {
  Watcher watcher;
  for (const std::string endpoint :
       {"", ":1667", "host:", "host:0", "host:65536", "host:x", "tcp://h"}) {
    EXPECT_THROW(LiveClient(endpoint, watcher), std::invalid_argument) << endpoint;
  }
  LiveClientOptions options;
  options.token = "short";
  EXPECT_THROW(LiveClient("localhost", watcher, options), std::invalid_argument);
}

// How soon is for people: in the properties of the test, and in `./dev bench live`.
TEST(LiveClient, EachTickArrivesWithoutTheNextOne) {
  Robot robot;
  Watcher watcher;
  const LiveClient client(robot.endpoint(), watcher);
  ASSERT_TRUE(watcher.Await(IsLive));
  std::vector<std::chrono::nanoseconds> latencies;
  for (std::uint64_t tick = 1; tick <= 500; ++tick) {
    const auto start = std::chrono::steady_clock::now();
    robot.Tick();
    ASSERT_TRUE(watcher.Await(HasTick(tick)));
    latencies.push_back(std::chrono::steady_clock::now() - start);
  }
  std::sort(latencies.begin(), latencies.end());
  RecordProperty("median_us", static_cast<int>(latencies[250].count() / 1000));
  RecordProperty("p99_us", static_cast<int>(latencies[495].count() / 1000));
}

}  // namespace
}  // namespace coppice
