// Robots and who looks for them, in a network of their own, with real multicast.
#include <arpa/inet.h>
#include <gmock/gmock.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <functional>
#include <optional>
#include <random>
#include <thread>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/live/discovery/announcer.h"
#include "bt_core/live/discovery/multicast_search.h"
#include "bt_core/live/discovery/multicast_socket.h"
#include "bt_core/live/server/live_publisher.h"
#include "tests/bt_core/live/discovery/own_network.h"
#include "tests/bt_core/live/live_client.h"
#include "tests/bt_core/live/watched_tree.h"
#include "tests/fuzz/mutator.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;

// No other test's robot has it, should the network not be an own one.
std::uint16_t SomePort() {
  return static_cast<std::uint16_t>(20000 + std::random_device()() % 20000);
}

// Somebody in the network who knows the protocol, or does not keep to it.
class Neighbour {
 public:
  explicit Neighbour(MulticastSocket::Kind kind)
      : socket_(context_, InterfacesOf("lo").at(0), kind,
                [this](std::string_view message, const MulticastSocket::Endpoint& from) {
                  heard_.emplace_back(message);
                  from_ = from;
                }) {
    socket_.Hear(1 << 20);
  }

  void Say(const std::string& message) { socket_.SendToAll(message); }
  void Answer(const std::string& message) { socket_.SendTo(message, from_); }

  // The next message of that kind; nothing if none comes in the time.
  std::optional<std::string> Hear(const std::function<bool(const std::string&)>& is_it,
                                  milliseconds time = seconds(20)) {
    const auto end = steady_clock::now() + time;
    while (steady_clock::now() < end) {
      context_.restart();
      context_.run_one_for(milliseconds(20));
      while (!heard_.empty()) {
        const std::string message = heard_.front();
        heard_.erase(heard_.begin());
        if (is_it(message)) return message;
      }
    }
    return std::nullopt;
  }

 private:
  boost::asio::io_context context_;
  MulticastSocket socket_;
  std::vector<std::string> heard_;
  MulticastSocket::Endpoint from_;
};

bool IsQuestion(const std::string& message) {
  return message.size() > 12 && (message[2] & 0x80) == 0;
}

std::uint16_t IdOf(const std::string& message) {
  return static_cast<std::uint16_t>(static_cast<unsigned char>(message[0]) << 8U |
                                    static_cast<unsigned char>(message[1]));
}

class DiscoveryTest : public testing::Test {
 protected:
  static RobotNotice Robot(std::uint16_t port) {
    RobotNotice robot = NoticeOfThisRobot(port, true);
    robot.tree = "Patrol";
    return robot;
  }

  static std::optional<FoundRobot> Find(MulticastSearch& search,
                                        const std::function<bool(const FoundRobot&)>& is_it) {
    const auto end = steady_clock::now() + seconds(30);
    while (steady_clock::now() < end) {
      for (const FoundRobot& robot : search.Look()) {
        if (is_it(robot)) return robot;
      }
      std::this_thread::yield();
    }
    return std::nullopt;
  }
  static std::optional<FoundRobot> Find(MulticastSearch& search, std::uint16_t port) {
    const std::string endpoint = "127.0.0.1:" + std::to_string(port);
    return Find(search, [&](const FoundRobot& robot) { return robot.endpoint == endpoint; });
  }

  const OwnNetwork network_;
  const std::uint16_t port_ = SomePort();
};

TEST_F(DiscoveryTest, ARobotThatTellsTheNetworkIsFound) {
  const Announcer announcer("lo", Robot(port_));
  MulticastSearch search({}, "lo");
  const std::optional<FoundRobot> robot = Find(search, port_);
  ASSERT_TRUE(robot);
  EXPECT_EQ(robot->tree, "Patrol");
  EXPECT_TRUE(robot->needs_token);
}

TEST_F(DiscoveryTest, WhoLooksIsWokenByNews) {
  std::atomic<bool> woken{false};
  MulticastSearch search([&] { woken = true; }, "lo");
  search.Look();
  const Announcer announcer("lo", Robot(port_));
  ASSERT_TRUE(Find(search, port_));
  EXPECT_TRUE(woken);
}

TEST_F(DiscoveryTest, AnotherTreeIsHeardOf) {
  Announcer announcer("lo", Robot(port_));
  MulticastSearch search({}, "lo");
  ASSERT_TRUE(Find(search, port_));
  announcer.SetTree("Docking");
  EXPECT_TRUE(Find(search, [](const FoundRobot& robot) { return robot.tree == "Docking"; }));
}

TEST_F(DiscoveryTest, WhoRestsAsksNobody) {
  Neighbour neighbour(MulticastSocket::Kind::kAnswers);
  MulticastSearch search({}, "lo");
  if (!network_.is_own()) return;  // others may ask in it
  EXPECT_FALSE(neighbour.Hear(IsQuestion, milliseconds(200)));
  search.Look();
  EXPECT_TRUE(neighbour.Hear(IsQuestion));
  search.Rest();
  while (neighbour.Hear(IsQuestion, milliseconds(1))) continue;
  EXPECT_FALSE(neighbour.Hear(IsQuestion, milliseconds(1100)));
}

TEST_F(DiscoveryTest, OtherToolsHearOfTheRobotAndThatItGoes) {
  Neighbour neighbour(MulticastSocket::Kind::kAnswers);
  const RobotNotice robot = Robot(port_);
  {
    const Announcer announcer("lo", robot);
    const std::string stays = AnnouncementMessage(robot, {127, 0, 0, 1});
    EXPECT_TRUE(neighbour.Hear([&](const std::string& heard) { return heard == stays; }));
    while (neighbour.Hear([](const std::string&) { return true; }, milliseconds(1))) continue;
    neighbour.Say(QuestionMessage(0));  // from the port of multicast DNS: all may hear the answer
    EXPECT_TRUE(neighbour.Hear([&](const std::string& heard) { return heard == stays; }));
  }
  const std::string goes = AnnouncementMessage(robot, {127, 0, 0, 1}, true);
  EXPECT_TRUE(neighbour.Hear([&](const std::string& heard) { return heard == goes; }));
}

// Each answer could be one to a sender that somebody made up.
TEST_F(DiscoveryTest, ARobotDoesNotAnswerWithoutEnd) {
  const Announcer announcer("lo", Robot(port_));
  Neighbour neighbour(MulticastSocket::Kind::kAsks);
  for (int i = 0; i < 2000; ++i) neighbour.Say(QuestionMessage(1));
  const auto is_answer = [](const std::string& heard) { return !IsQuestion(heard); };
  ASSERT_TRUE(neighbour.Hear(is_answer));
  int answers = 1;
  while (neighbour.Hear(is_answer, milliseconds(300))) ++answers;
  EXPECT_LT(answers, 200);
}

TEST_F(DiscoveryTest, ARobotOutlivesBrokenQuestions) {
  const Announcer announcer("lo", Robot(port_));
  Neighbour neighbour(MulticastSocket::Kind::kAsks);
  std::string question = QuestionMessage(7);
  for (unsigned seed = 0; seed < 5000; ++seed) {
    neighbour.Say(fuzz::Mutator(seed).Mutate(question));
  }
  MulticastSearch search({}, "lo");
  EXPECT_TRUE(Find(search, port_));
}

// A stranger answers each question with broken answers and a crowd of robots.
TEST_F(DiscoveryTest, WhoLooksOutlivesAStrangerWhoFloods) {
  MulticastSearch search({}, "lo");
  Neighbour stranger(MulticastSocket::Kind::kAnswers);
  search.Look();
  std::optional<std::string> question = stranger.Hear(IsQuestion);
  ASSERT_TRUE(question);
  const RobotNotice robot = Robot(port_);
  const RobotQuestion asked{IdOf(*question), question->substr(12)};
  const std::string answer = AnswerMessage(robot, {127, 0, 0, 1}, asked);
  for (unsigned seed = 0; seed < 5000; ++seed) {
    stranger.Answer(fuzz::Mutator(seed).Mutate(answer));
  }
  const std::optional<std::string> again = stranger.Hear(IsQuestion);
  ASSERT_TRUE(again);
  for (std::uint16_t port = 1; port < 200; ++port) {
    RobotNotice one = Robot(port);
    one.tree = std::string(60, 'x');
    stranger.Answer(AnswerMessage(one, {127, 0, 0, 1}, {IdOf(*again), asked.bytes}));
  }
  ASSERT_TRUE(Find(search, [](const FoundRobot&) { return true; }));
  EXPECT_TRUE(stranger.Hear(IsQuestion)) << "it goes on";
  const std::vector<FoundRobot> found = search.Look();
  EXPECT_LE(found.size(), 8u);
  for (const FoundRobot& one : found) {
    EXPECT_LE(one.tree.size(), kLongestNoticeText);
    EXPECT_EQ(one.endpoint.substr(0, 10), "127.0.0.1:") << "where the answer came from";
  }
}

TEST_F(DiscoveryTest, AnAnswerToAQuestionThatNobodyAskedIsNotBelieved) {
  MulticastSearch search({}, "lo");
  Neighbour stranger(MulticastSocket::Kind::kAnswers);
  search.Look();
  const std::optional<std::string> question = stranger.Hear(IsQuestion);
  ASSERT_TRUE(question);
  const auto wrong = static_cast<std::uint16_t>(IdOf(*question) + 1);
  stranger.Answer(AnswerMessage(Robot(port_), {127, 0, 0, 1}, {wrong, ""}));
  const auto other = static_cast<std::uint16_t>(port_ + 1);
  stranger.Answer(AnswerMessage(Robot(other), {127, 0, 0, 1}, {IdOf(*question), ""}));
  EXPECT_TRUE(Find(search, other));
  for (const FoundRobot& robot : search.Look()) {
    EXPECT_NE(robot.endpoint, "127.0.0.1:" + std::to_string(port_));
  }
}

class ServedRobot {
 public:
  explicit ServedRobot(bool announce) : live_(stream_, Options(announce)) {}
  std::uint16_t port() const { return live_.port(); }

 private:
  static LiveOptions Options(bool announce) {
    LiveOptions options = FreePort();
    options.announce = announce;
    options.name = "Watched";
    return options;
  }

  SimulatedClock clock_;
  Executor executor_{WatchedProgram(), clock_};
  EventStream stream_{executor_};
  LivePublisher live_;
};

TEST_F(DiscoveryTest, ALiveViewTellsTheNetworkIfItIsAskedTo) {
  const ServedRobot silent(false);
  const ServedRobot robot(true);
  MulticastSearch search({}, "lo");
  const std::optional<FoundRobot> found = Find(search, robot.port());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->tree, "Watched");
  EXPECT_FALSE(found->needs_token);
  for (const FoundRobot& one : search.Look()) {
    EXPECT_NE(one.endpoint, "127.0.0.1:" + std::to_string(silent.port()));
  }
}

}  // namespace
}  // namespace coppice
