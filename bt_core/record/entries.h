// What a record says, as values: the header once, then ticks, notes and gaps in the order of
// happening.
#ifndef COPPICE_BT_CORE_RECORD_ENTRIES_H_
#define COPPICE_BT_CORE_RECORD_ENTRIES_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bt_core/engine/events.h"
#include "bt_core/model/document.h"

namespace coppice {

struct RecordedDocument {
  std::string file;
  std::string text;
};

struct RecordedNode {
  std::string path;  ///< as Program::Path
  std::string id;
  NodeIndex parent = 0;        ///< itself for the root
  std::uint32_t document = 0;  ///< of RecordHeader::documents
  ElementIndex element = 0;    ///< in that document
};

struct RecordedSlot {
  std::string scope;
  std::string key;  ///< a mailbox or literal has no key but the name "node path.port"
  std::string type;
};

/// A blackboard value as Value::Print writes it; nothing if the key has no value.
using RecordedValue = std::optional<std::string>;

/// Everything that a tree remembers, as far as people can see it.
struct RecordedState {
  std::vector<Status> statuses;
  std::vector<RecordedValue> values;
};

using Metadata = std::vector<std::pair<std::string, std::string>>;

struct RecordHeader {
  std::uint32_t version = 0;
  std::string writer;  ///< program and compiler
  std::string main_tree;
  Time start{0};      ///< in the tree's clock
  Metadata metadata;  ///< of the application
  std::vector<RecordedDocument> documents;
  std::vector<RecordedNode> nodes;
  std::vector<RecordedSlot> slots;
  RecordedState state;  ///< at the start
};

struct RecordedWrite {
  SlotIndex slot;
  RecordedValue value;
};

/// A tick in which something happened, or a halt (with result kIdle).
struct RecordedTick {
  Time time{0};
  std::uint64_t tick = 0;
  Status result = Status::kIdle;
  std::vector<StatusChange> changes;
  std::vector<RecordedWrite> writes;
  std::vector<NodeMessage> messages;
};

/// Something that the application wanted to be in the record.
struct RecordedNote {
  Time time{0};
  std::string kind;
  std::string text;
};

/// Ticks with events and notes that were lost because the disk was too slow. The state is that
/// after the tick that follows, so a picture of the tree is right again from there.
struct RecordedGap {
  Time time{0};
  std::uint64_t lost_ticks = 0;
  std::uint64_t first_tick = 0;
  std::uint64_t last_tick = 0;
  std::uint64_t lost_notes = 0;
  RecordedState state;
};

/// The record was closed in order.
struct RecordedEnd {
  Time time{0};
  std::uint64_t ticks = 0;  ///< of the executor so far, also those in which nothing happened
};

using RecordEntry = std::variant<RecordedTick, RecordedNote, RecordedGap, RecordedEnd>;

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_ENTRIES_H_
