// The events of a tick as a sequence of 32-bit words, the form in which they go from the ticking
// thread to everyone who watches.
//
// Most events are one word: the node times 8, plus the status that its tick returned, or 0 if it
// was reset on its own: halted, or made idle while its parent goes on. When a node ends, all nodes
// below it are idle; when a Sequence or Fallback of any kind is RUNNING, the children behind the
// one that was ticked last are idle. No words say so: StatusFollower (status_follower.h) knows.
//
// The other events are three words and then bytes, filled up to a whole word:
//
//   index * 8 + code | writer, or kind of text | number of bytes | bytes
//
// Writes stand before the result of the node that wrote, and before what it said and what its
// children did afterwards; texts stand before the result of their node. Of several writes of a slot
// only the last one before such an event is there.
//
//   EventReader reader(events.words);
//   for (Event event; reader.Next(event);) ...
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_WORDS_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_WORDS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/status.h"
#include "bt_core/data/blackboard.h"
#include "bt_core/nodes/control.h"

namespace coppice {

/// Words that lie elsewhere.
struct EventWords {
  const std::uint32_t* data = nullptr;
  std::size_t size = 0;
};

enum class EventCode : std::uint32_t {
  kReset = 0,  ///< the node is IDLE now
  kRunning = 1,
  kSuccess = 2,
  kFailure = 3,
  kSkipped = 4,
  kWrite = 5,     ///< a slot was written by a node; bytes as in data/value_bytes.h
  kDelivery = 6,  ///< a slot was written by what lay in the inbox; the same bytes
  kText = 7,      ///< something that a node says
};

enum class EventText : std::uint32_t {
  kMessage = 0,    ///< why a leaf did what it did
  kException = 1,  ///< the text of an exception
  kInjected = 2,   ///< one byte: the status that somebody outside put in place of the node's own
};

/// One event, taken apart.
struct Event {
  EventCode code = EventCode::kReset;
  std::uint32_t index = 0;     ///< a slot for kWrite and kDelivery, else a node
  NodeIndex writer = kNoNode;  ///< of kWrite; kNoNode: not known which
  EventText text = EventText::kMessage;
  std::string_view bytes;  ///< valid as long as the words

  NodeIndex node() const { return NodeIndex(index); }
  SlotIndex slot() const { return SlotIndex(index); }
  bool is_result() const { return code >= EventCode::kRunning && code <= EventCode::kSkipped; }
  bool is_status() const { return code <= EventCode::kSkipped; }
  /// Of a reset or a result.
  Status status() const { return static_cast<Status>(code); }
};

class EventReader {
 public:
  explicit EventReader(EventWords words) : at_(words.data), end_(words.data + words.size) {}
  /// False at the end, and at words that are cut off.
  bool Next(Event& event);

 private:
  const std::uint32_t* at_;
  const std::uint32_t* end_;
};

/// Why a node did what it did: a message of a leaf, the text of an exception.
struct NodeMessage {
  NodeIndex node;
  std::string text;
};

/// The messages and exceptions among events, in their order.
std::vector<NodeMessage> MessagesOf(EventWords words);

/// Appends events. Memory grows to the longest tick and is kept.
class EventWriter {
 public:
  EventWriter() { Grow(); }
  EventWriter(const EventWriter&) = delete;
  EventWriter& operator=(const EventWriter&) = delete;

  void Reset(NodeIndex node) { Put(node << 3); }
  void Status(NodeIndex node, coppice::Status status) {
    Put(node << 3 | static_cast<std::uint32_t>(status));
  }
  /// There is room for one more word without growing.
  bool has_room() const { return next_ != end_; }
  void Write(SlotIndex slot, NodeIndex writer, const Value& value);
  void Delivery(SlotIndex slot, const Value& value);
  void Text(NodeIndex node, EventText kind, std::string_view text);
  /// The same with bytes that are there already.
  void Add(EventCode code, std::uint32_t index, std::uint32_t second, std::string_view bytes);

  /// Valid until the next event.
  EventWords words() const {
    return {words_.data(), static_cast<std::size_t>(next_ - words_.data())};
  }
  bool empty() const { return next_ == words_.data(); }
  void Clear() { next_ = words_.data(); }

 private:
  void Put(std::uint32_t word) {
    if (!has_room()) Grow();
    *next_++ = word;
  }
  void Grow();

  std::vector<std::uint32_t> words_;
  std::uint32_t* next_ = nullptr;  // where the next word goes
  std::uint32_t* end_ = nullptr;
  std::string bytes_;  // of the value that is being written
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_WORDS_H_
