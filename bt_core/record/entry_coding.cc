#include "bt_core/record/entry_coding.h"

#include <exception>
#include <string>
#include <unordered_map>
#include <utility>

#include "bt_core/history/frame.h"

namespace coppice {
namespace {

enum class Kind : std::uint8_t { kEmpty, kText, kBool, kSigned, kUnsigned, kDouble };

void Tag(Kind kind, Encoder& out) { out.Byte(static_cast<std::uint8_t>(kind)); }

void EncodePrinted(const Value& value, Encoder& out) {
  Tag(Kind::kText, out);
  try {
    out.Text(value.Print());
  } catch (const std::exception& error) {
    out.Text(std::string("cannot be printed: ") + error.what());
  }
}

RecordedValue DecodeValue(Decoder& in) {
  switch (static_cast<Kind>(in.Byte())) {
    case Kind::kEmpty:
      return std::nullopt;
    case Kind::kText:
      return in.Text();
    case Kind::kBool:
      return ValueTraits<bool>::Print(in.Byte() != 0);
    case Kind::kSigned:
      return ValueTraits<std::int64_t>::Print(in.Signed());
    case Kind::kUnsigned:
      return ValueTraits<std::uint64_t>::Print(in.Unsigned());
    case Kind::kDouble:
      return ValueTraits<double>::Print(in.Double());
  }
  in.Index(0);  // no such kind: an error
  return std::nullopt;
}

Status DecodeStatus(Decoder& in) { return static_cast<Status>(in.Index(5)); }

void EncodeState(const std::vector<Status>& statuses, const Blackboard& blackboard, Encoder& out) {
  for (const Status status : statuses) out.Byte(static_cast<std::uint8_t>(status));
  for (const Slot& slot : blackboard) EncodeValue(slot.value, out);
}

RecordedState DecodeState(Decoder& in, std::size_t nodes, std::size_t slots) {
  RecordedState state;
  for (std::size_t i = 0; i < nodes && in.ok(); ++i) state.statuses.push_back(DecodeStatus(in));
  for (std::size_t i = 0; i < slots && in.ok(); ++i) state.values.push_back(DecodeValue(in));
  return state;
}

// Names for the slots that have no key: "path of the node.port". The port of a script has none.
std::unordered_map<SlotIndex, std::string> PortNames(const Program& program) {
  std::unordered_map<SlotIndex, std::string> names;
  for (NodeIndex node = 0; node < program.nodes.size(); ++node) {
    const Registry::Entry* entry = program.info[node].entry;
    if (!entry) continue;
    const std::uint32_t first = program.FirstPort(node);
    for (std::uint32_t k = 0; k < entry->declarations.size(); ++k) {
      if (entry->declarations[k].type == &TypeOf<ScriptCode>()) continue;
      names.emplace(program.ports[first + k].slot,
                    program.Path(node) + "." + entry->declarations[k].name);
    }
  }
  return names;
}

void EncodeNodes(const Program& program, Encoder& out) {
  out.Unsigned(program.nodes.size());
  for (NodeIndex node = 0; node < program.nodes.size(); ++node) {
    out.Text(program.Path(node));
    out.Text(program.Id(node));
    out.Unsigned(program.info[node].parent);
    out.Unsigned(program.info[node].document);
    out.Unsigned(program.info[node].element);
  }
}

void EncodeSlots(const Program& program, Encoder& out) {
  auto names = PortNames(program);
  const Layout& layout = program.layout;
  out.Unsigned(layout.slots.size());
  for (SlotIndex slot = 0; slot < layout.slots.size(); ++slot) {
    const SlotDefinition& definition = layout.slots[slot];
    out.Text(layout.scopes[definition.scope]);
    out.Text(definition.key.empty() ? names[slot] : definition.key);
    out.Text(definition.type ? definition.type->name : "any");
  }
}

template <class T>
std::optional<T> WholeOrNothing(const Decoder& in, T value) {
  if (!in.ok() || !in.at_end()) return std::nullopt;
  return value;
}

}  // namespace

void EncodeValue(const Value& value, Encoder& out) {
  if (!value.has_value()) {
    Tag(Kind::kEmpty, out);
  } else if (value.Is<double>()) {
    Tag(Kind::kDouble, out);
    out.Double(value.Get<double>());
  } else if (value.Is<bool>()) {
    Tag(Kind::kBool, out);
    out.Byte(value.Get<bool>());
  } else if (value.Is<int>()) {
    Tag(Kind::kSigned, out);
    out.Signed(value.Get<int>());
  } else if (value.Is<std::int64_t>()) {
    Tag(Kind::kSigned, out);
    out.Signed(value.Get<std::int64_t>());
  } else if (value.Is<unsigned>()) {
    Tag(Kind::kUnsigned, out);
    out.Unsigned(value.Get<unsigned>());
  } else if (value.Is<std::uint64_t>()) {
    Tag(Kind::kUnsigned, out);
    out.Unsigned(value.Get<std::uint64_t>());
  } else if (value.Is<std::string>()) {
    Tag(Kind::kText, out);
    out.Text(value.Get<std::string>());
  } else {
    EncodePrinted(value, out);
  }
}

void EncodeHeader(Executor& executor, const Metadata& metadata, Encoder& out) {
  const Program& program = executor.program();
  out.Text("Coppice 0.1.0, compiler " __VERSION__);
  out.Text(program.trees.front().id);
  out.At(executor.clock().Now());
  out.Unsigned(metadata.size());
  for (const auto& [key, value] : metadata) {
    out.Text(key);
    out.Text(value);
  }
  out.Unsigned(program.project->documents().size());
  for (const Document& document : program.project->documents()) {
    out.Text(document.file());
    out.Text(document.text());
  }
  EncodeNodes(program, out);
  EncodeSlots(program, out);
  EncodeState(executor.statuses(), executor.blackboard(), out);
}

void EncodeTick(const TickEvents& events, Encoder& out) {
  out.At(events.start);
  out.Unsigned(events.tick);
  out.Byte(static_cast<std::uint8_t>(events.result));
  out.Unsigned(events.changes.size());
  for (const StatusChange& change : events.changes) {
    out.Unsigned(change.node);
    out.Byte(static_cast<std::uint8_t>(static_cast<unsigned>(change.from) << 4 |
                                       static_cast<unsigned>(change.to)));
  }
  out.Unsigned(events.writes.size());
  for (const SlotIndex slot : events.writes) {
    out.Unsigned(slot);
    EncodeValue(events.blackboard[slot].value, out);
  }
  out.Unsigned(events.messages.size());
  for (const NodeMessage& message : events.messages) {
    out.Unsigned(message.node);
    out.Text(message.text);
  }
}

void EncodeNote(const RecordedNote& note, Encoder& out) {
  out.At(note.time);
  out.Text(note.kind);
  out.Text(note.text);
}

void EncodeGap(const RecordedGap& gap, const std::vector<Status>& statuses,
               const Blackboard& blackboard, Encoder& out) {
  out.At(gap.time);
  out.Unsigned(gap.lost_ticks);
  out.Unsigned(gap.first_tick);
  out.Unsigned(gap.last_tick);
  out.Unsigned(gap.lost_notes);
  EncodeState(statuses, blackboard, out);
}

void EncodeEnd(const RecordedEnd& end, Encoder& out) {
  out.At(end.time);
  out.Unsigned(end.ticks);
}

std::optional<RecordHeader> DecodeHeader(Decoder in) {
  RecordHeader header;
  header.version = kRecordVersion;
  header.writer = in.Text();
  header.main_tree = in.Text();
  header.start = in.At();
  header.metadata.resize(in.Count());
  for (auto& [key, value] : header.metadata) {
    key = in.Text();
    value = in.Text();
  }
  header.documents.resize(in.Count());
  for (RecordedDocument& document : header.documents) {
    document.file = in.Text();
    document.text = in.Text();
  }
  header.nodes.resize(in.Count());
  for (RecordedNode& node : header.nodes) {
    node.path = in.Text();
    node.id = in.Text();
    node.parent = in.Index(header.nodes.size());
    node.document = in.Index(header.documents.size());
    node.element = in.Index(kNoElement);
  }
  header.slots.resize(in.Count());
  for (RecordedSlot& slot : header.slots) {
    slot.scope = in.Text();
    slot.key = in.Text();
    slot.type = in.Text();
  }
  header.state = DecodeState(in, header.nodes.size(), header.slots.size());
  return WholeOrNothing(in, std::move(header));
}

std::optional<RecordedTick> DecodeTick(Decoder in, const RecordHeader& header) {
  RecordedTick tick;
  tick.time = in.At();
  tick.tick = in.Unsigned();
  tick.result = DecodeStatus(in);
  tick.changes.resize(in.Count());
  for (StatusChange& change : tick.changes) {
    change.node = in.Index(header.nodes.size());
    const std::uint8_t statuses = in.Byte();
    if (statuses >> 4 > 4 || (statuses & 15) > 4) return std::nullopt;
    change.from = static_cast<Status>(statuses >> 4);
    change.to = static_cast<Status>(statuses & 15);
  }
  tick.writes.resize(in.Count());
  for (RecordedWrite& write : tick.writes) {
    write.slot = in.Index(header.slots.size());
    write.value = DecodeValue(in);
  }
  tick.messages.resize(in.Count());
  for (NodeMessage& message : tick.messages) {
    message.node = in.Index(header.nodes.size());
    message.text = in.Text();
  }
  return WholeOrNothing(in, std::move(tick));
}

std::optional<RecordedNote> DecodeNote(Decoder in) {
  RecordedNote note;
  note.time = in.At();
  note.kind = in.Text();
  note.text = in.Text();
  return WholeOrNothing(in, std::move(note));
}

std::optional<RecordedGap> DecodeGap(Decoder in, const RecordHeader& header) {
  RecordedGap gap;
  gap.time = in.At();
  gap.lost_ticks = in.Unsigned();
  gap.first_tick = in.Unsigned();
  gap.last_tick = in.Unsigned();
  gap.lost_notes = in.Unsigned();
  gap.state = DecodeState(in, header.nodes.size(), header.slots.size());
  return WholeOrNothing(in, std::move(gap));
}

std::optional<RecordedEnd> DecodeEnd(Decoder in) {
  RecordedEnd end;
  end.time = in.At();
  end.ticks = in.Unsigned();
  return WholeOrNothing(in, end);
}

}  // namespace coppice
