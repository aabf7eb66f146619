#include "bt_core/live/server/live_publisher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <random>

#include "bt_core/live/debug/debugger.h"
#include "tests/bt_core/live/live_client.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class LivePublisherTest : public ::testing::Test {
 protected:
  void Tick() {
    executor_.Tick();
    stream_.Flush();
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
  EventStream stream_{executor_};
  LivePublisher live_{stream_, FreePort()};
  PlainClient client_{live_.port()};
};

TEST_F(LivePublisherTest, ServesTheTree) {
  const Parts reply = client_.Ask('T');
  ASSERT_EQ(reply.size(), 2u);
  EXPECT_EQ(reply[0].size(), 22u);
  EXPECT_EQ(reply[0].substr(0, 6), PlainClient::Header('T'));
  EXPECT_THAT(reply[1], HasSubstr(R"(<BehaviorTree ID="Inner" _fullpath="inner">)"));
}

TEST_F(LivePublisherTest, ServesTheStatusOfEveryNode) {
  using P = std::pair<int, int>;
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 0}, P{2, 0}, P{3, 0}, P{4, 0}, P{6, 0}, P{5, 0}));
  Tick();
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 1}, P{2, 2}, P{3, 2}, P{4, 12}, P{6, 1}, P{5, 12}));
  Tick();
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 1}, P{2, 2}, P{3, 2}, P{4, 13}, P{6, 1}, P{5, 13}));
  executor_.Halt();
  stream_.Flush();
  EXPECT_THAT(Statuses(), ElementsAre(P{1, 11}, P{2, 12}, P{3, 12}, P{4, 13}, P{6, 11}, P{5, 13}));
}

TEST_F(LivePublisherTest, ServesTheBlackboardWithoutTheTickingThread) {
  Tick();
  const Parts reply = client_.Ask({PlainClient::Header('B'), "Main;inner"});
  ASSERT_EQ(reply.size(), 2u);
  const auto boards = nlohmann::json::from_msgpack(reply[1]);
  EXPECT_EQ(boards["Main"]["spot"], "3;-4");
  EXPECT_EQ(boards["Main"]["number"], 1);
  EXPECT_EQ(boards["inner"]["literal"], 7);
}

TEST_F(LivePublisherTest, ServesAnotherTreeWhenAnotherProgramIsSwappedIn) {
  const std::string id = client_.Ask('S').at(0).substr(6);
  executor_.Reload(CompileText(R"(<root BTCPP_format="4"><BehaviorTree ID="Other">)"
                               R"(<AlwaysSuccess name="alone"/></BehaviorTree></root>)"));
  stream_.Flush();
  EXPECT_THAT(client_.Ask('T').at(1), HasSubstr("alone"));
  const Parts reply = client_.Ask('S');
  EXPECT_NE(reply.at(0).substr(6), id);
  EXPECT_EQ(reply.at(1).size(), 3u);
}

TEST_F(LivePublisherTest, KeepsItsTreeIdAndAnotherPublisherHasAnother) {
  const std::string id = client_.Ask('S').at(0).substr(6);
  EXPECT_EQ(client_.Ask('T').at(0).substr(6), id);
  Executor other(WatchedProgram(), clock_);
  EventStream other_stream(other);
  const LivePublisher other_live(other_stream, FreePort());
  EXPECT_NE(PlainClient(other_live.port()).Ask('S').at(0).substr(6), id);
}

TEST_F(LivePublisherTest, IsNotDisturbedByRandomRequests) {
  auto fuzz = std::async(std::launch::async, [port = live_.port()] {
    std::mt19937 random(7);
    PlainClient client(port);
    int replies = 0;
    for (int i = 0; i < 3000; ++i) {
      Parts request(1 + random() % 3);
      for (std::string& part : request) {
        part.resize(random() % 3 ? 6 : random() % 100);
        for (char& c : part) c = static_cast<char>(random());
      }
      if (request[0].size() > 1) request[0][1] = "TSBBIRUDAXrtNC?"[random() % 15];
      if (request[0].size() == 6) request[0][5] = 1;  // number 0 of the extension has no reply
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

TEST_F(LivePublisherTest, LetsItsProgramReleaseTheTree) {
  EXPECT_EQ(live_.debugger().Pause().problem(), "");
  auto tick = std::async(std::launch::async, [&] { return executor_.Tick(); });
  live_.debugger().ReleaseAll();
  ASSERT_EQ(tick.wait_for(30s), std::future_status::ready);
  EXPECT_EQ(tick.get(), Status::kRunning);
}

TEST(LivePublisher, StopsListeningToTheTreeWhenItEnds) {
  SimulatedClock clock;
  Executor executor(WatchedProgram(), clock);
  EventStream stream(executor);
  { const LivePublisher live(stream, FreePort()); }
  EXPECT_EQ(executor.Tick(), Status::kRunning);
}

TEST(LivePublisher, ThrowsIfThePortIsInUse) {
  SimulatedClock clock;
  Executor executor(WatchedProgram(), clock);
  EventStream stream(executor);
  const LivePublisher live(stream, FreePort());
  LiveOptions taken;
  taken.port = live.port();
  EXPECT_THROW(LivePublisher(stream, taken), std::runtime_error);
}

}  // namespace
}  // namespace coppice
