#include "bt_core/data/port.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace coppice {
namespace {

struct Owner : PortOwner {
  Input<int> count{this, "count", "how many"};
  Input<double> speed{this, "speed", "how fast [m/s]", 0.5};
  Input<std::string> label{this, "label", "may be left out", kOptional};
  Output<double> distance{this, "distance", "driven [m]"};
  InOut<int> total{this, "total", "sum so far"};
  Mailbox<bool> answer{this, "answer"};
};

const Time now{Duration(5)};  // of the tick in which the ports are used

TEST(PortDirection, HasAName) {
  EXPECT_STREQ(ToString(PortDirection::kInput), "input");
  EXPECT_STREQ(ToString(PortDirection::kOutput), "output");
  EXPECT_STREQ(ToString(PortDirection::kInOut), "inout");
  EXPECT_STREQ(ToString(PortDirection::kMailbox), "mailbox");
}

TEST(PortCollector, GathersDeclarationsInOrder) {
  const PortCollector collector;
  const Owner owner;
  ASSERT_EQ(collector.ports.size(), 6U);
  EXPECT_EQ(collector.ports[0].declaration.name, "count");
  EXPECT_EQ(collector.ports[0].declaration.type, &TypeOf<int>());
  EXPECT_EQ(collector.ports[0].declaration.description, "how many");
  EXPECT_EQ(collector.ports[3].declaration.direction, PortDirection::kOutput);
  EXPECT_EQ(collector.ports[4].declaration.direction, PortDirection::kInOut);
  EXPECT_EQ(collector.ports[5].declaration.direction, PortDirection::kMailbox);
  EXPECT_EQ(collector.ports[0].port, &owner.count);
}

TEST(PortCollector, KnowsWhatMustBeGiven) {
  const PortCollector collector;
  const Owner owner;
  EXPECT_TRUE(collector.ports[0].declaration.required);
  EXPECT_FALSE(collector.ports[1].declaration.required);
  EXPECT_EQ(collector.ports[1].declaration.default_text, "0.5");
  EXPECT_FALSE(collector.ports[2].declaration.required);
  EXPECT_FALSE(collector.ports[2].declaration.default_text.has_value());
  EXPECT_FALSE(collector.ports[3].declaration.required);
  EXPECT_TRUE(collector.ports[4].declaration.required);
}

TEST(PortCollector, TheInnermostOneGathers) {
  const PortCollector outer;
  {
    const PortCollector inner;
    const Owner owner;
    EXPECT_EQ(inner.ports.size(), 6U);
  }
  EXPECT_TRUE(outer.ports.empty());
  const Owner owner;
  EXPECT_EQ(outer.ports.size(), 6U);
}

TEST(Input, ThrowsWhileNobodyHasWritten) {
  Owner owner;
  EXPECT_THROW(owner.count.Get(), UnsetInput) << "not bound";
  Slot slot;
  owner.count.Bind(&slot, now, SlotIndex{0}, nullptr);
  EXPECT_FALSE(owner.count.has_value());
  EXPECT_THROW(*owner.count, UnsetInput);
}

TEST(Input, ReadsItsSlot) {
  Owner owner;
  Slot slot{Value(12), Time(Duration(7)), 3, 0};
  owner.count.Bind(&slot, now, SlotIndex{0}, nullptr);
  EXPECT_EQ(*owner.count, 12);
  EXPECT_EQ(owner.count.writes(), 3U);
  EXPECT_EQ(owner.count.stamp(), Time(Duration(7)));
}

TEST(Output, WritesAndCounts) {
  Owner owner;
  Slot slot;
  owner.distance.Bind(&slot, now, SlotIndex{0}, nullptr);
  owner.distance.Set(1.5);
  owner.distance.Set(1.5);
  EXPECT_EQ(slot.value.Get<double>(), 1.5);
  EXPECT_EQ(slot.writes, 2U);
  EXPECT_EQ(slot.stamp, now);
}

TEST(Output, LeftOutOfTheXmlIsWithoutEffect) {
  Owner owner;
  EXPECT_FALSE(owner.distance.is_bound());
  owner.distance.Set(1.5);
}

TEST(InOut, ReadsWhatItWrote) {
  Owner owner;
  Slot slot;
  owner.total.Bind(&slot, now, SlotIndex{0}, nullptr);
  EXPECT_THROW(owner.total.Get(), UnsetInput);
  owner.total.Set(4);
  owner.total.Set(owner.total.Get() + 1);
  EXPECT_EQ(owner.total.Get(), 5);
}

struct MailboxTest : testing::Test {
  void SetUp() override { owner.answer.Bind(&slot, now, SlotIndex{9}, inbox); }
  // What the executor does at the start of a tick.
  void Deliver() {
    std::vector<Inbox::Message> messages;
    inbox->TakeMessages(messages);
    for (Inbox::Message& message : messages) {
      EXPECT_EQ(message.slot, 9U);
      slot.value = message.value;
      slot.epoch = message.epoch;
      ++slot.writes;
    }
  }
  const std::shared_ptr<Inbox> inbox = std::make_shared<Inbox>();
  Slot slot;
  Owner owner;
};

TEST_F(MailboxTest, GivesAnAnswerOnce) {
  const Sender<bool> sender = owner.answer.NewSender();
  EXPECT_EQ(owner.answer.Take(), nullptr);
  sender.Send(true);
  Deliver();
  const bool* answer = owner.answer.Take();
  ASSERT_NE(answer, nullptr);
  EXPECT_TRUE(*answer);
  EXPECT_EQ(owner.answer.Take(), nullptr);
}

TEST_F(MailboxTest, NeverShowsAnAnswerToAnEarlierQuestion) {
  const Sender<bool> old = owner.answer.NewSender();
  const Sender<bool> current = owner.answer.NewSender();
  old.Send(false);
  Deliver();
  EXPECT_EQ(owner.answer.Take(), nullptr);
  current.Send(true);
  Deliver();
  ASSERT_NE(owner.answer.Take(), nullptr);
}

TEST_F(MailboxTest, ForgetsAnAnswerThatCameBeforeTheQuestion) {
  owner.answer.NewSender().Send(true);
  Deliver();
  owner.answer.NewSender();
  EXPECT_EQ(owner.answer.Take(), nullptr);
}

TEST(Mailbox, UnboundGivesASenderThatDrops) {
  Owner owner;
  EXPECT_FALSE(owner.answer.NewSender());
  EXPECT_EQ(owner.answer.Take(), nullptr);
}

}  // namespace
}  // namespace coppice
