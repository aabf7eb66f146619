#include "editor/live/live_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>

namespace coppice::editor {
namespace {

class Teller : public LiveListener {
 public:
  void OnConnection(const LiveConnection& connection) override {
    told += connection.is_live ? "live " : "gone ";
  }
  void OnTree(const TreeDescription& tree) override { told += "tree " + tree.main_tree + " "; }
  void OnState(const HistoryState& state) override {
    told += "state " + std::to_string(state.tick) + " ";
  }
  void OnTick(const TickEvents& events) override {
    told += "tick " + std::to_string(events.tick) + ":";
    for (std::size_t i = 0; i < events.words.size; ++i) {
      told += std::to_string(events.words.data[i]) + " ";
    }
  }
  void OnPicture(const LivePicture& picture) override {
    told += picture.name + "=" + picture.text + " ";
  }
  std::string told;
};

TEST(LiveQueueTest, TellsAgainInOrderWhatWasToldOnAnotherThread) {
  int wakes = 0;
  LiveQueue queue([&wakes] { ++wakes; });
  EXPECT_TRUE(queue.empty());
  std::thread([&queue] {
    LiveConnection connection;
    connection.is_live = true;
    queue.OnConnection(connection);
    TreeDescription tree;
    tree.main_tree = "Main";
    queue.OnTree(tree);
    queue.OnState({});
    const std::uint32_t words[] = {10, 20, 30};
    queue.OnTick({1, Time(Duration(1)), Duration(0), Status::kRunning, true, {words, 2}});
    queue.OnTick({2, Time(Duration(2)), Duration(0), Status::kRunning, true, {words + 2, 1}});
  }).join();
  EXPECT_EQ(wakes, 1) << "once, until it is emptied";
  Teller teller;
  queue.Deliver(teller);
  EXPECT_EQ(teller.told, "live tree Main state 0 tick 1:10 20 tick 2:30 ");
  EXPECT_TRUE(queue.empty());
}

TEST(LiveQueueTest, HandsOnTheNewestPictureOfEachNameAlone) {
  int wakes = 0;
  LiveQueue queue([&wakes] { ++wakes; });
  const auto show = [&](const std::string& name, const std::string& text) {
    queue.OnPicture({name, text, 1, 1, {0, 0, 0}});
  };
  for (int i = 0; i <= 1000; ++i) show("face", std::to_string(i));
  show("ears", "up");
  EXPECT_FALSE(queue.empty());
  EXPECT_EQ(wakes, 1);
  Teller teller;
  queue.Deliver(teller);
  EXPECT_EQ(teller.told, "ears=up face=1000 ");
  EXPECT_TRUE(queue.empty());
}

TEST(LiveQueueTest, APictureOfAConnectionThatIsGoneIsNotHandedOn) {
  LiveQueue queue(nullptr);
  queue.OnPicture({"face", "old", 1, 1, {0, 0, 0}});
  queue.OnConnection({});
  queue.OnPicture({"ears", "new", 1, 1, {0, 0, 0}});
  Teller teller;
  queue.Deliver(teller);
  EXPECT_EQ(teller.told, "gone ears=new ");
}

TEST(LiveQueueTest, WhoTellsFasterThanTheOtherTakesItWaits) {
  constexpr std::uint64_t kTicks = 1000;
  LiveQueue queue(nullptr, 1000);  // bytes: room for a few
  const auto tell = [&queue] {
    for (std::uint64_t i = 1; i <= kTicks; ++i) {
      queue.OnTick({i, Time{}, Duration(0), Status::kRunning, true, {}});
    }
  };
  struct Counter : LiveListener {
    void OnTree(const TreeDescription&) override {}
    void OnState(const HistoryState&) override {}
    void OnTick(const TickEvents& events) override { last = events.tick; }
    std::uint64_t last = 0;
  } counter;
  std::thread teller(tell);
  std::uint64_t most = 0;
  while (counter.last < kTicks) {
    const std::uint64_t before = counter.last;
    queue.Deliver(counter);
    most = std::max(most, counter.last - before);
  }
  teller.join();
  EXPECT_LT(most, 100U);
  std::thread left(tell);  // nobody takes it any more
  queue.StopWaiting();
  left.join();
}

TEST(LiveQueueTest, CallsTheHandlersOfRepliesWhenItDelivers) {
  LiveQueue queue(nullptr);
  std::string error;
  queue.PutReply([&error](const LiveReply& reply) { error = reply.problem(); }, Problem{"no"});
  EXPECT_EQ(error, "");
  Teller teller;
  queue.Deliver(teller);
  EXPECT_EQ(error, "no");
}

}  // namespace
}  // namespace coppice::editor
