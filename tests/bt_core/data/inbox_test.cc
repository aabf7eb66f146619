#include "bt_core/data/inbox.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace coppice {
namespace {

using std::chrono::seconds;

TEST(Inbox, GivesMessagesInTheOrderOfPosting) {
  Inbox inbox;
  inbox.Post(SlotIndex{3}, 1, Value(10));
  inbox.Post(SlotIndex{4}, 2, Value(std::string("x")));
  ASSERT_TRUE(inbox.has_messages());
  std::vector<Inbox::Message> messages;
  inbox.TakeMessages(messages);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].slot, 3U);
  EXPECT_EQ(messages[0].value.Get<int>(), 10);
  EXPECT_EQ(messages[1].epoch, 2U);
  EXPECT_EQ(messages[1].value.Get<std::string>(), "x");
}

TEST(Inbox, IsEmptyAfterTaking) {
  Inbox inbox;
  inbox.Post(SlotIndex{0}, 0, Value(1));
  std::vector<Inbox::Message> messages;
  inbox.TakeMessages(messages);
  EXPECT_FALSE(inbox.has_messages());
  inbox.TakeMessages(messages);
  EXPECT_TRUE(messages.empty()) << "taking replaces what the argument held";
}

TEST(Inbox, PostingWakes) {
  Inbox inbox;
  inbox.Post(SlotIndex{0}, 0, Value(1));
  EXPECT_TRUE(inbox.wake_up().WaitFor(seconds(0)));
  inbox.PostCall([] {});
  EXPECT_TRUE(inbox.wake_up().WaitFor(seconds(0)));
}

TEST(Inbox, CallsAreKeptApartFromMessages) {
  Inbox inbox;
  int called = 0;
  inbox.PostCall([&called] { ++called; });
  EXPECT_TRUE(inbox.has_calls());
  EXPECT_FALSE(inbox.has_messages());
  std::vector<Inbox::Call> calls;
  inbox.TakeCalls(calls);
  ASSERT_EQ(calls.size(), 1U);
  calls[0]();
  EXPECT_EQ(called, 1);
  EXPECT_FALSE(inbox.has_calls());
}

TEST(Inbox, LosesNothingThatManyThreadsPost) {
  constexpr int kThreads = 4;
  constexpr int kEach = 2000;
  Inbox inbox;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&inbox, t] {
      for (int i = 0; i < kEach; ++i) inbox.Post(static_cast<SlotIndex>(t), 0, Value(i));
    });
  }
  std::vector<int> next(kThreads, 0);
  std::vector<Inbox::Message> messages;
  int received = 0;
  while (received < kThreads * kEach) {
    ASSERT_TRUE(inbox.has_messages() || inbox.wake_up().WaitFor(seconds(10)));
    inbox.TakeMessages(messages);
    for (const Inbox::Message& message : messages) {
      EXPECT_EQ(message.value.Get<int>(), next[message.slot]++);
      ++received;
    }
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(Sender, PostsToItsSlotAndEpoch) {
  const auto inbox = std::make_shared<Inbox>();
  const Sender<double> sender(inbox, SlotIndex{5}, 7);
  sender.Send(0.5);
  std::vector<Inbox::Message> messages;
  inbox->TakeMessages(messages);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].slot, 5U);
  EXPECT_EQ(messages[0].epoch, 7U);
  EXPECT_EQ(messages[0].value.Get<double>(), 0.5);
}

TEST(Sender, MadeByDefaultDrops) {
  const Sender<int> sender;
  EXPECT_FALSE(sender);
  sender.Send(1);
}

TEST(Sender, WorksAfterTheReceiverIsGone) {
  auto inbox = std::make_shared<Inbox>();
  const Sender<std::string> sender(inbox, SlotIndex{0}, 0);
  inbox.reset();
  EXPECT_TRUE(sender);
  sender.Send("late");
}

TEST(Inbox, ARequestForATickIsTakenOnce) {
  Inbox inbox;
  EXPECT_FALSE(inbox.TakeTickRequest());
  inbox.RequestTick();
  inbox.RequestTick();
  EXPECT_TRUE(inbox.wake_up().WaitFor(std::chrono::seconds(0)));
  EXPECT_TRUE(inbox.TakeTickRequest());
  EXPECT_FALSE(inbox.TakeTickRequest());
}

}  // namespace
}  // namespace coppice
