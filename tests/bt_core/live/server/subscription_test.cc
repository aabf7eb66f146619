#include "bt_core/live/server/subscription.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using From = Subscription::From;

class SubscriptionTest : public ::testing::Test {
 protected:
  SubscriptionTest() {
    Add(FrameType::kTree, "T");
    Add(FrameType::kState, "S");
  }
  void Add(FrameType type, const std::string& bytes) { store_.Add({type, tick_++, Time{}, bytes}); }
  void AddEvents(int count) {
    for (int i = 0; i < count; ++i) Add(FrameType::kEvents, "e");
  }
  // The types of the frames of a gap, whose first frame is a real one.
  static std::string Print(const std::optional<Push>& push) {
    if (!push) return "nothing";
    return std::to_string(push->first) + "-" + std::to_string(push->next) + " " + push->frames;
  }

  std::uint64_t tick_ = 0;
  FrameStore store_{100};
};

TEST_F(SubscriptionTest, BeginsWithTreeAndStateAndGoesOn) {
  AddEvents(2);
  Subscription subscription(store_, From::kOldest, 0, 1000);
  EXPECT_EQ(subscription.missed(), 0u);
  EXPECT_EQ(subscription.next(), 1u);
  EXPECT_EQ(Print(subscription.Next(store_)), "1-4 TSee");
  EXPECT_EQ(Print(subscription.Next(store_)), "nothing");
  AddEvents(1);
  EXPECT_EQ(Print(subscription.Next(store_)), "4-5 e");
}

TEST_F(SubscriptionTest, GoesOnAtANumberThatIsKept) {
  AddEvents(3);
  Subscription subscription(store_, From::kNumber, 3, 1000);
  EXPECT_EQ(subscription.missed(), 0u);
  EXPECT_EQ(Print(subscription.Next(store_)), "3-5 ee");
  Subscription at_the_end(store_, From::kNumber, 5, 1000);
  EXPECT_EQ(Print(at_the_end.Next(store_)), "nothing");
}

TEST_F(SubscriptionTest, BeginsAnewAtANumberThatThereIsNot) {
  Subscription subscription(store_, From::kNumber, 77, 1000);
  EXPECT_EQ(Print(subscription.Next(store_)), "1-2 TS");
}

TEST_F(SubscriptionTest, BeginsAtTheYoungestState) {
  AddEvents(5);
  Add(FrameType::kState, "S");
  Subscription subscription(store_, From::kYoungest, 0, 1000);
  EXPECT_EQ(Print(subscription.Next(store_)), "7-8 TS");
}

TEST_F(SubscriptionTest, SaysHowMuchIsKeptNoLonger) {
  AddEvents(98);
  Add(FrameType::kState, "S");
  ASSERT_EQ(store_.first(), 100u);
  EXPECT_EQ(Subscription(store_, From::kOldest, 0, 1000).missed(), 100u);
  EXPECT_EQ(Subscription(store_, From::kNumber, 90, 1000).missed(), 10u);
}

TEST_F(SubscriptionTest, SendsNoMoreThanTheWindowUntilItIsAcknowledged) {
  AddEvents(20);
  Subscription subscription(store_, From::kNumber, 2, 8);
  EXPECT_EQ(Print(subscription.Next(store_)), "2-10 eeeeeeee");
  EXPECT_EQ(Print(subscription.Next(store_)), "nothing");
  subscription.Acknowledge(9);  // not all of that message
  EXPECT_EQ(Print(subscription.Next(store_)), "nothing");
  subscription.Acknowledge(10);
  EXPECT_EQ(Print(subscription.Next(store_)), "10-18 eeeeeeee");
}

TEST_F(SubscriptionTest, WaitsForRoomAndKeepsNothingMeanwhile) {
  AddEvents(2);
  Subscription subscription(store_, From::kOldest, 0, 1000);
  EXPECT_EQ(Print(subscription.Next(store_, 0)), "1-1 ");
  EXPECT_EQ(Print(subscription.Next(store_, 2)), "1-2 TS");
  EXPECT_EQ(Print(subscription.Next(store_, 0)), "2-2 ");
  EXPECT_EQ(Print(subscription.Next(store_, 1)), "2-3 e");
}

TEST_F(SubscriptionTest, BeginsWithTheTreeThatHeldAtItsState) {
  FrameStore store(10000);
  store.Add({FrameType::kTree, 1, Time{}, "T"});
  store.Add({FrameType::kState, 1, Time{}, "S"});
  Subscription subscription(store, From::kOldest, 0, 1000);
  store.Add({FrameType::kTree, 2, Time{}, "U"});
  store.Add({FrameType::kState, 2, Time{}, "V"});
  EXPECT_EQ(Print(subscription.Next(store)), "1-4 TSUV");
}

TEST_F(SubscriptionTest, SendsAFrameThatIsLargerThanTheWindowAlone) {
  Add(FrameType::kEvents, std::string(50, 'x'));
  AddEvents(1);
  Subscription subscription(store_, From::kNumber, 2, 1);
  EXPECT_EQ(Print(subscription.Next(store_)), "2-3 " + std::string(50, 'x'));
  EXPECT_EQ(Print(subscription.Next(store_)), "nothing");
  subscription.Acknowledge(3);
  EXPECT_EQ(Print(subscription.Next(store_)), "3-4 e");
}

TEST_F(SubscriptionTest, CrossesAHoleWithAGapTreeAndState) {
  Subscription subscription(store_, From::kOldest, 0, 1000);
  subscription.Next(store_);
  AddEvents(98);
  Add(FrameType::kState, "S");
  const std::optional<Push> push = subscription.Next(store_);
  ASSERT_TRUE(push);
  EXPECT_EQ(push->first, 100u);
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(push->frames.data());
  const FrameHeader header = ReadFrameHeader(bytes);
  EXPECT_EQ(static_cast<FrameType>(header.type), FrameType::kGap);
  EXPECT_TRUE(IsWhole(bytes, header));
  EXPECT_EQ(push->frames.substr(kFrameHeaderSize + header.payload_size), "TS");
}

}  // namespace
}  // namespace coppice
