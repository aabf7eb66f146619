#include "bt_core/engine/events/event_words.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bt_core/data/value_bytes.h"
#include "bt_core/engine/events/for_each_event.h"

namespace coppice {
namespace {

TEST(EventWords, ComeBackInTheirOrder) {
  EventWriter writer;
  writer.Delivery(SlotIndex{3}, Value(7));
  writer.Write(SlotIndex{4}, NodeIndex{2}, Value(std::string("door")));
  writer.Status(NodeIndex{2}, Status::kFailure);
  writer.Text(NodeIndex{1}, EventText::kException, "no map");
  writer.Reset(NodeIndex{5});
  EventReader reader(writer.words());
  Event event;
  ASSERT_TRUE(reader.Next(event));
  EXPECT_EQ(event.code, EventCode::kDelivery);
  EXPECT_EQ(event.index, 3U);
  EXPECT_EQ(PrintValueBytes(event.bytes), "7");
  ASSERT_TRUE(reader.Next(event));
  EXPECT_EQ(event.code, EventCode::kWrite);
  EXPECT_EQ(event.writer, 2U);
  EXPECT_EQ(PrintValueBytes(event.bytes), "door");
  ASSERT_TRUE(reader.Next(event));
  EXPECT_TRUE(event.is_result());
  EXPECT_EQ(event.index, 2U);
  EXPECT_EQ(event.status(), Status::kFailure);
  ASSERT_TRUE(reader.Next(event));
  EXPECT_EQ(event.text, EventText::kException);
  EXPECT_EQ(event.bytes, "no map");
  ASSERT_TRUE(reader.Next(event));
  EXPECT_EQ(event.code, EventCode::kReset);
  EXPECT_FALSE(event.is_result());
  EXPECT_FALSE(reader.Next(event));
}

TEST(EventWords, TextsOfAnyLengthFit) {
  for (std::size_t size = 0; size < 9; ++size) {
    EventWriter writer;
    writer.Text(NodeIndex{1}, EventText::kMessage, std::string(size, 'x'));
    writer.Status(NodeIndex{1}, Status::kSuccess);
    EventReader reader(writer.words());
    Event event;
    ASSERT_TRUE(reader.Next(event));
    EXPECT_EQ(event.bytes, std::string(size, 'x'));
    ASSERT_TRUE(reader.Next(event));
    EXPECT_EQ(event.status(), Status::kSuccess);
  }
}

std::string Describe(const Event& event) {
  if (event.is_status()) return std::to_string(event.index) + ToString(event.status());
  return std::to_string(event.index) + " " + std::to_string(event.writer) + " " +
         std::string(event.bytes);
}

std::vector<std::string> ReadAll(EventWords words) {
  std::vector<std::string> events;
  EventReader reader(words);
  for (Event event; reader.Next(event);) events.push_back(Describe(event));
  return events;
}

std::vector<std::string> ForAll(EventWords words) {
  std::vector<std::string> events;
  ForEachEvent(
      words,
      [&](NodeIndex node, Status status) {
        Event event;
        event.code = static_cast<EventCode>(status);
        event.index = node;
        events.push_back(Describe(event));
      },
      [&](const Event& event) { events.push_back(Describe(event)); });
  return events;
}

TEST(ForEachEvent, ReadsWhatTheReaderReads) {
  EventWriter writer;
  writer.Status(NodeIndex{2}, Status::kFailure);
  for (std::size_t size = 0; size < 9; ++size) {
    writer.Text(NodeIndex{1}, EventText::kMessage, std::string(size, 'x'));
    writer.Add(EventCode::kWrite, 4, 2, std::string(size, 'y'));
    writer.Reset(static_cast<NodeIndex>(size));
  }
  for (std::size_t size = 0; size <= writer.words().size; ++size) {
    const EventWords words{writer.words().data, size};
    EXPECT_EQ(ForAll(words), ReadAll(words)) << size;
  }
}

TEST(EventWords, ThatAreCutOffEndTheReading) {
  EventWriter writer;
  writer.Text(NodeIndex{1}, EventText::kMessage, "a long text");
  for (std::size_t size = 1; size < writer.words().size; ++size) {
    EventReader reader({writer.words().data, size});
    Event event;
    EXPECT_FALSE(reader.Next(event)) << size;
    EXPECT_FALSE(reader.Next(event)) << size;
  }
}

TEST(EventWords, MessagesAndExceptionsAreMessages) {
  EventWriter writer;
  writer.Text(NodeIndex{1}, EventText::kMessage, "blocked");
  writer.Text(NodeIndex{2}, EventText::kInjected, "x");
  writer.Text(NodeIndex{3}, EventText::kException, "no map");
  const std::vector<NodeMessage> messages = MessagesOf(writer.words());
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].node, 1U);
  EXPECT_EQ(messages[1].text, "no map");
}

}  // namespace
}  // namespace coppice
