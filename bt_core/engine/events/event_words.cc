#include "bt_core/engine/events/event_words.h"

#include <cstring>

#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

constexpr std::size_t kWord = sizeof(std::uint32_t);

std::size_t WordsFor(std::size_t bytes) { return (bytes + kWord - 1) / kWord; }

}  // namespace

bool EventReader::Next(Event& event) {
  if (at_ == end_) return false;
  event = Event();
  event.code = static_cast<EventCode>(*at_ & 7);
  event.index = *at_ >> 3;
  ++at_;
  if (event.is_status()) return true;
  const auto left = static_cast<std::size_t>(end_ - at_);
  if (left < 2 || WordsFor(at_[1]) > left - 2) {
    at_ = end_;
    return false;
  }
  if (event.code == EventCode::kWrite) event.writer = NodeIndex(at_[0]);
  if (event.code == EventCode::kText) event.text = static_cast<EventText>(at_[0]);
  event.bytes = std::string_view(reinterpret_cast<const char*>(at_ + 2), at_[1]);
  at_ += 2 + WordsFor(at_[1]);
  return true;
}

std::vector<NodeMessage> MessagesOf(EventWords words) {
  std::vector<NodeMessage> messages;
  EventReader reader(words);
  for (Event event; reader.Next(event);) {
    if (event.code != EventCode::kText || event.text == EventText::kInjected) continue;
    messages.push_back({event.node(), std::string(event.bytes)});
  }
  return messages;
}

void EventWriter::Add(EventCode code, std::uint32_t index, std::uint32_t second,
                      std::string_view bytes) {
  const std::size_t words = WordsFor(bytes.size());
  while (static_cast<std::size_t>(end_ - next_) < 3 + words) Grow();
  next_[0] = index << 3 | static_cast<std::uint32_t>(code);
  next_[1] = second;
  next_[2] = static_cast<std::uint32_t>(bytes.size());
  next_ += 3;
  if (words == 0) return;
  next_[words - 1] = 0;  // where the bytes do not fill a word
  std::memcpy(next_, bytes.data(), bytes.size());
  next_ += words;
}

void EventWriter::Grow() {
  constexpr std::size_t kFirstSize = 64;
  const std::size_t used = words().size;
  words_.resize(words_.empty() ? kFirstSize : 2 * words_.size());
  next_ = words_.data() + used;
  end_ = words_.data() + words_.size();
}

void EventWriter::Write(SlotIndex slot, NodeIndex writer, const Value& value) {
  bytes_.clear();
  AppendValueBytes(value, bytes_);
  Add(EventCode::kWrite, slot, writer, bytes_);
}

void EventWriter::Delivery(SlotIndex slot, const Value& value) {
  bytes_.clear();
  AppendValueBytes(value, bytes_);
  Add(EventCode::kDelivery, slot, 0, bytes_);
}

void EventWriter::Text(NodeIndex node, EventText kind, std::string_view text) {
  Add(EventCode::kText, node, static_cast<std::uint32_t>(kind), text);
}

}  // namespace coppice
