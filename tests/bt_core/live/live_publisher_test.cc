#include "bt_core/live/live_publisher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <nlohmann/json.hpp>
#include <random>
#include <zmq.hpp>

#include "tests/bt_core/live/watched_tree.h"
#include "tests/bt_core/record/counting_new.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

using Parts = std::vector<std::string>;

LiveOptions FreePort() {
  LiveOptions options;
  options.port = 0;
  return options;
}

/// Asks as any client of the protocol does.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(context_, zmq::socket_type::req) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 30000);
    socket_.connect("tcp://127.0.0.1:" + std::to_string(port));
  }

  Parts Ask(const Parts& request) {
    for (std::size_t i = 0; i < request.size(); ++i) {
      const bool last = i + 1 == request.size();
      socket_.send(zmq::buffer(request[i]),
                   last ? zmq::send_flags::none : zmq::send_flags::sndmore);
    }
    Parts reply;
    zmq::message_t part;
    do {
      if (!socket_.recv(part)) return {"no reply within 30 s"};
      reply.push_back(part.to_string());
    } while (part.more());
    return reply;
  }

  Parts Ask(char type) { return Ask({Header(type)}); }
  static std::string Header(char type) { return std::string("\x02") + type + "abcd"; }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

class LivePublisherTest : public ::testing::Test {
 protected:
  // Ticks the tree until the other thread is done.
  template <class T>
  T TickUntil(std::future<T> done) {
    while (done.wait_for(0s) != std::future_status::ready) executor_.Tick();
    return done.get();
  }

  // uid and status byte of every node, in the order of the reply.
  std::vector<std::pair<int, int>> Statuses() {
    const Parts reply = client_.Ask('S');
    std::vector<std::pair<int, int>> statuses;
    for (std::size_t i = 0; reply.size() == 2 && i + 2 < reply[1].size(); i += 3) {
      statuses.emplace_back(reply[1][i] | reply[1][i + 1] << 8, reply[1][i + 2]);
    }
    return statuses;
  }

  SimulatedClock clock_;
  Executor executor_{WatchedProgram(), clock_};
  LivePublisher live_{executor_, FreePort()};
  Client client_{live_.port()};
};

TEST_F(LivePublisherTest, ServesTheTree) {
  const Parts reply = client_.Ask('T');
  ASSERT_EQ(reply.size(), 2u);
  EXPECT_EQ(reply[0].size(), 22u);
  EXPECT_EQ(reply[0].substr(0, 6), Client::Header('T'));
  EXPECT_THAT(reply[1], HasSubstr("<BehaviorTree ID=\"Inner\" _fullpath=\"inner\">"));
}

TEST_F(LivePublisherTest, ServesTheStatusOfEveryNode) {
  using P = std::pair<int, int>;
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 0}, P{2, 0}, P{3, 0}, P{4, 0}, P{6, 0}, P{5, 0}));
  executor_.Tick();
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 1}, P{2, 2}, P{3, 2}, P{4, 12}, P{6, 1}, P{5, 12}));
  executor_.Tick();
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 1}, P{2, 2}, P{3, 2}, P{4, 13}, P{6, 1}, P{5, 13}));
  executor_.Halt();
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 11}, P{2, 12}, P{3, 12}, P{4, 13}, P{6, 11}, P{5, 13}));
}

TEST_F(LivePublisherTest, ServesTheBlackboardOfTheTickingTree) {
  executor_.Tick();
  const Parts reply = TickUntil(std::async(std::launch::async, [&] {
    return client_.Ask({Client::Header('B'), "Main;inner"});
  }));
  ASSERT_EQ(reply.size(), 2u);
  const auto boards = nlohmann::json::from_msgpack(reply[1]);
  EXPECT_EQ(boards["Main"]["spot"], "3;-4");
  EXPECT_GT(boards["Main"]["number"], 0);
  EXPECT_EQ(boards["inner"]["literal"], 7);
}

TEST_F(LivePublisherTest, ServesTheLastKnownBlackboardOfATreeThatNobodyTicks) {
  const Parts reply = client_.Ask({Client::Header('B'), "inner"});
  ASSERT_EQ(reply.size(), 2u);
  EXPECT_EQ(nlohmann::json::from_msgpack(reply[1])["inner"]["literal"], 7);
}

TEST_F(LivePublisherTest, AnswersWhatItCannotServeWithAnError) {
  EXPECT_THAT(client_.Ask({"short"}), ElementsAre("error", "wrong request header"));
  EXPECT_THAT(client_.Ask('B'), ElementsAre("error", "must be 2 parts message"));
  EXPECT_THAT(client_.Ask('?'), ElementsAre("error", "Request not recognized"));
  EXPECT_THAT(client_.Ask('I'), ElementsAre("error", HasSubstr("not supported")));
  EXPECT_EQ(client_.Ask('S').size(), 2u);  // goes on
}

TEST_F(LivePublisherTest, KeepsItsTreeIdAndAnotherPublisherHasAnother) {
  const std::string id = client_.Ask('S').at(0).substr(6);
  EXPECT_EQ(client_.Ask('T').at(0).substr(6), id);
  Executor other(WatchedProgram(), clock_);
  const LivePublisher other_live(other, FreePort());
  EXPECT_NE(Client(other_live.port()).Ask('S').at(0).substr(6), id);
}

TEST_F(LivePublisherTest, IsNotDisturbedByRandomRequests) {
  auto fuzz = std::async(std::launch::async, [port = live_.port()] {
    std::mt19937 random(7);
    Client client(port);
    int replies = 0;
    for (int i = 0; i < 3000; ++i) {
      Parts request(1 + random() % 3);
      for (std::string& part : request) {
        part.resize(random() % 3 ? 6 : random() % 100);
        for (char& c : part) c = static_cast<char>(random());
      }
      if (request[0].size() > 1) request[0][1] = "TSBBIRUDAXrtN?"[random() % 14];
      if (request.size() > 1 && random() % 2) request[1] = "Main;inner;;x";
      const Parts reply = client.Ask(request);
      replies += reply[0].size() == 22 || (reply[0] == "error" && !reply.at(1).empty());
    }
    return replies;
  });
  Executor undisturbed(WatchedProgram(), clock_);
  while (fuzz.wait_for(0s) != std::future_status::ready) {
    EXPECT_EQ(executor_.Tick(), undisturbed.Tick());
    EXPECT_EQ(executor_.statuses(), undisturbed.statuses());
  }
  EXPECT_EQ(fuzz.get(), 3000);
}

TEST_F(LivePublisherTest, DoesNotAllocateWhenTheTreeTicks) {
  executor_.Tick();
  executor_.Tick();
  const std::uint64_t before = Allocations();
  for (int i = 0; i < 100; ++i) executor_.Tick();
  EXPECT_EQ(Allocations(), before);
}

TEST(LivePublisher, EndsWhileAClientWaitsForTheBlackboard) {
  SimulatedClock clock;
  Executor executor(WatchedProgram(), clock);
  LiveOptions options = FreePort();
  options.patience = 1h;
  auto live = std::make_unique<LivePublisher>(executor, options);
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::req);
  socket.set(zmq::sockopt::linger, 0);
  socket.connect("tcp://127.0.0.1:" + std::to_string(live->port()));
  socket.send(zmq::buffer(Client::Header('B')), zmq::send_flags::sndmore);
  socket.send(zmq::str_buffer("Main"));
  ASSERT_TRUE(executor.wake_up().WaitFor(30s));  // the request has reached the tree
  live.reset();
  executor.Tick();
}

TEST(LivePublisher, StopsListeningToTheTreeWhenItEnds) {
  SimulatedClock clock;
  Executor executor(WatchedProgram(), clock);
  { const LivePublisher live(executor, FreePort()); }
  EXPECT_EQ(executor.Tick(), Status::kRunning);
}

TEST(LivePublisher, ThrowsIfThePortIsInUse) {
  SimulatedClock clock;
  Executor executor(WatchedProgram(), clock);
  const LivePublisher live(executor, FreePort());
  LiveOptions taken;
  taken.port = live.port();
  EXPECT_THROW(LivePublisher(executor, taken), std::runtime_error);
}

}  // namespace
}  // namespace coppice
