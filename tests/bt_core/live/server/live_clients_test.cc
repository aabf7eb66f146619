#include "bt_core/live/server/live_clients.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class KeptConnection : public LiveConnection {
 public:
  void Post(groot2::Parts message, std::size_t bytes) override {
    posted.push_back(std::move(message));
    room += bytes;
  }
  void ReadOn() override { ++read_on; }
  void CutOff() override { is_cut_off = true; }

  std::vector<groot2::Parts> posted;
  std::size_t room = 0;
  int read_on = 0;
  bool is_cut_off = false;
};

class LiveClientsTest : public ::testing::Test {
 protected:
  ReceivedRequest Receive() {
    ReceivedRequest request;
    EXPECT_TRUE(clients_.Receive(request));
    return request;
  }

  int calls_ = 0;
  LiveClients clients_{[this] { ++calls_; }};
  std::shared_ptr<KeptConnection> first_ = std::make_shared<KeptConnection>();
  std::shared_ptr<KeptConnection> second_ = std::make_shared<KeptConnection>();
};

TEST_F(LiveClientsTest, GivesEachConnectionANumberThatIsNeverUsedAgain) {
  const ClientId one = clients_.Enter(first_, true);
  clients_.Leave(one);
  EXPECT_NE(clients_.Enter(second_, true), one);
}

TEST_F(LiveClientsTest, HandsRequestsOverWithTheRightsOfTheirConnection) {
  clients_.Put(clients_.Enter(first_, true), {"a"});
  clients_.Put(clients_.Enter(second_, false), {"b"});
  EXPECT_EQ(calls_, 2);
  EXPECT_TRUE(Receive().may_control);
  EXPECT_EQ(first_->read_on, 1);
  EXPECT_EQ(second_->read_on, 0) << "its request was not taken yet";
  EXPECT_FALSE(Receive().may_control);
}

TEST_F(LiveClientsTest, KnowsSinceWhenARequestWaits) {
  const Duration later = std::chrono::steady_clock::now().time_since_epoch() + 1h;
  EXPECT_EQ(clients_.HeardUntil(later), later);
  clients_.Put(clients_.Enter(first_, false), {"a"});
  const Duration arrived = clients_.HeardUntil(later);
  EXPECT_LT(arrived, later);
  EXPECT_EQ(Receive().arrived, arrived);
  EXPECT_EQ(clients_.HeardUntil(later), later);
}

TEST_F(LiveClientsTest, SaysByeForWhoHasGone) {
  const ClientId client = clients_.Enter(first_, true);
  clients_.Put(client, {"hello"});
  Receive();
  clients_.Leave(client);
  clients_.Leave(client);
  EXPECT_THAT(Receive().parts, ElementsAre(::testing::_, HasSubstr("bye")));
  EXPECT_EQ(clients_.Send(client, {"x"}), SendResult::kGone);
  ReceivedRequest none;
  EXPECT_FALSE(clients_.Receive(none));
}

TEST_F(LiveClientsTest, DropsWhatWasNotTakenFromWhoHasGone) {
  const ClientId client = clients_.Enter(first_, true);
  clients_.Put(client, {"a request"});
  clients_.Leave(client);
  ReceivedRequest none;
  EXPECT_FALSE(clients_.Receive(none)) << "nor a bye, for it holds nothing";
}

TEST_F(LiveClientsTest, ServesThoseWhoMayControlBeforeThoseWhoMayNot) {
  clients_.Put(clients_.Enter(first_, false), {"reader"});
  clients_.Put(clients_.Enter(second_, true), {"controller"});
  EXPECT_TRUE(Receive().may_control);
  EXPECT_FALSE(Receive().may_control);
}

TEST_F(LiveClientsTest, ManyLargeAnswersThatNobodyReadsHaveALimitTogether) {
  const std::string large(30 << 20, 'x');
  std::size_t room = 0;
  for (int i = 0; i < 20; ++i) {
    const auto connection = std::make_shared<KeptConnection>();
    clients_.Reply(clients_.Enter(connection, true), {large});
    room += connection->room;
  }
  EXPECT_LE(room, LiveClients::kMaxRepliesInAll);
}

TEST_F(LiveClientsTest, KeepsLittleForWhoDoesNotReadButAnswersHim) {
  const ClientId client = clients_.Enter(first_, true);
  const std::string large(1 << 20, 'x');
  SendResult result = SendResult::kSent;
  while (result == SendResult::kSent && first_->posted.size() < 100) {
    result = clients_.Send(client, {large});
  }
  EXPECT_EQ(result, SendResult::kFull);
  EXPECT_LE(first_->room, LiveClients::kMaxUnreadBytes);
  EXPECT_EQ(clients_.Reply(client, {"pong"}), SendResult::kSent);
  clients_.GiveRoom(client, first_->room);
  EXPECT_EQ(clients_.Send(client, {large}), SendResult::kSent);
}

TEST_F(LiveClientsTest, HangsUpOnWhoAsksOnAndOnAndDoesNotRead) {
  const ClientId client = clients_.Enter(first_, true);
  const std::string large(1 << 20, 'x');
  while (clients_.Reply(client, {large}) == SendResult::kSent && first_->posted.size() < 100) {
  }
  EXPECT_TRUE(first_->is_cut_off);
  EXPECT_LE(first_->room, 3 * LiveClients::kMaxUnreadBytes);
}

TEST_F(LiveClientsTest, KeepsNotMuchMoreForManyThanForAFew) {
  const std::string large(3 << 20, 'x');
  std::size_t room = 0;
  for (int i = 0; i < 100; ++i) {
    const auto connection = std::make_shared<KeptConnection>();
    const ClientId client = clients_.Enter(connection, true);
    clients_.Send(client, {"small"});
    clients_.Send(client, {large});
    room += connection->room;
  }
  EXPECT_LE(room, LiveClients::kMaxUnreadInAll + (1 << 20));
}

TEST_F(LiveClientsTest, SaysHowMuchItWouldTake) {
  const ClientId client = clients_.Enter(first_, true);
  EXPECT_GT(clients_.RoomFor(client), LiveClients::kMaxUnreadInAll) << "one message, of any size";
  clients_.Send(client, {std::string(1 << 20, 'x')});
  const std::size_t room = clients_.RoomFor(client);
  EXPECT_LT(room, 3u << 20);
  EXPECT_EQ(clients_.Send(client, {"header", std::string(room + 1000, 'x')}), SendResult::kFull);
  EXPECT_EQ(clients_.Send(client, {"header", std::string(room, 'x')}), SendResult::kSent);
}

TEST_F(LiveClientsTest, PublishesToWhoAskedForTheTopic) {
  clients_.SetTopics(clients_.EnterListener(first_), {"ab"});
  clients_.SetTopics(clients_.EnterListener(second_), {""});
  clients_.Publish({"abc", "1"});
  clients_.Publish({"b", "2"});
  EXPECT_THAT(first_->posted, SizeIs(1));
  EXPECT_THAT(second_->posted, SizeIs(2));
}

}  // namespace
}  // namespace coppice
