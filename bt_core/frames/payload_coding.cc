#include "bt_core/frames/payload_coding.h"

#include <algorithm>
#include <utility>

#include "bt_core/frames/frame.h"

namespace coppice {
namespace {

constexpr std::uint8_t kRunsOneChild = 0x80;  // beside the category of a node
constexpr std::uint8_t kHasKey = 1;
constexpr std::size_t kCategories = 5;
constexpr std::size_t kStatuses = 5;
constexpr int kLastShift = 4;  // of the last status, beside the present one

// Together they must leave a description that a reader takes; longer values are cut.
constexpr std::size_t kMuchText = 16 << 20;

// A tree that runs has no more nodes. A node that is all zeros takes fifteen times its bytes when
// it is decoded, so the rest has a limit, too.
constexpr std::size_t kMostNodes = 1'000'000;
constexpr std::size_t kMostListBytes = std::size_t{160} << 20;  // of all lists, without their texts

// Makes room for the elements of lists of one description, as many as they are said to be.
class ListRoom {
 public:
  /// The number of elements that follow; 0 after more than there may be.
  template <class T>
  std::size_t Begin(Decoder& in, std::vector<T>& list) {
    const std::size_t count = in.Count();
    if (count > left_ / sizeof(T)) {
      in.Fail();
      return 0;
    }
    left_ -= count * sizeof(T);
    list.reserve(count);
    return count;
  }

 private:
  std::size_t left_ = kMostListBytes;
};

template <class T>
std::optional<T> WholeOrNothing(const Decoder& in, T value) {
  if (!in.ok() || !in.at_end()) return std::nullopt;
  return value;
}

void EncodeInfo(const RunInfo& info, Encoder& out) {
  for (const std::uint8_t byte : info.run) out.Byte(byte);
  out.Text(info.clock);
  out.At(info.start);
  out.Signed(info.wall_start.time_since_epoch().count());
  out.Unsigned(info.metadata.size());
  for (const auto& [key, value] : info.metadata) {
    out.Text(key);
    out.Text(value);
  }
}

RunInfo DecodeInfo(Decoder& in, ListRoom& room) {
  RunInfo info;
  for (std::uint8_t& byte : info.run) byte = in.Byte();
  info.clock = in.Text();
  info.start = in.At();
  info.wall_start = WallTime(Duration(in.Signed()));
  for (std::size_t left = room.Begin(in, info.metadata); left > 0 && in.ok(); --left) {
    std::string key = in.Text();
    info.metadata.emplace_back(std::move(key), in.Text());
  }
  return info;
}

void EncodeNode(const DescribedNode& node, Encoder& out) {
  out.Text(node.path);
  out.Text(node.id);
  out.Byte(static_cast<std::uint8_t>(static_cast<unsigned>(node.category) |
                                     (node.runs_one_child ? kRunsOneChild : 0u)));
  out.Unsigned(node.parent);
  out.Unsigned(node.document);
  out.Unsigned(node.element);
  out.Unsigned(node.ports.size());
  for (const DescribedPort& port : node.ports) {
    out.Text(port.name);
    out.Unsigned(port.slot);
  }
}

DescribedNode DecodeNode(Decoder& in, std::size_t documents, ListRoom& room) {
  DescribedNode node;
  node.path = in.Text();
  node.id = in.Text();
  const std::uint8_t kind = in.Byte();
  if ((kind & ~kRunsOneChild) >= kCategories) in.Fail();
  node.category = static_cast<NodeCategory>(kind & ~kRunsOneChild);
  node.runs_one_child = (kind & kRunsOneChild) != 0;
  node.parent = NodeIndex(in.Index(kNoNode));
  node.document = in.Index(documents);
  node.element = ElementIndex(in.Index(kNoElement));
  for (std::size_t left = room.Begin(in, node.ports); left > 0 && in.ok(); --left) {
    std::string name = in.Text();
    node.ports.push_back({std::move(name), SlotIndex(in.Index(kNoSlot))});
  }
  return node;
}

DescribedSlot DecodeSlot(Decoder& in) {
  DescribedSlot slot;
  slot.scope = in.Text();
  slot.name = in.Text();
  slot.type = in.Text();
  slot.has_key = (in.Byte() & kHasKey) != 0;
  return slot;
}

// In preorder, a node's parent is the node before it or an ancestor of that one.
bool IsPreorder(const std::vector<DescribedNode>& nodes) {
  if (nodes.empty() || nodes[0].parent != 0) return false;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    std::size_t ancestor = i - 1;
    while (ancestor > nodes[i].parent) ancestor = nodes[ancestor].parent;
    if (ancestor != nodes[i].parent) return false;
  }
  return true;
}

bool PortsHaveSlots(const TreeDescription& tree) {
  for (const DescribedNode& node : tree.nodes) {
    for (const DescribedPort& port : node.ports) {
      if (port.slot >= tree.slots.size()) return false;
    }
  }
  return true;
}

}  // namespace

void EncodeTree(const TreeDescription& tree, Encoder& out) {
  out.Text(tree.writer);
  EncodeInfo(tree.info, out);
  out.Text(tree.main_tree);
  out.Unsigned(tree.documents.size());
  std::size_t left = kMuchText;
  for (const DescribedDocument& document : tree.documents) {
    const std::string text = CutText(document.text, left);
    out.Text(document.file);
    out.Text(text);
    left -= std::min(text.size(), left);
  }
  out.Text(CutText(tree.models, kMuchText));
  out.Unsigned(tree.nodes.size());
  for (const DescribedNode& node : tree.nodes) EncodeNode(node, out);
  out.Unsigned(tree.slots.size());
  for (const DescribedSlot& slot : tree.slots) {
    out.Text(slot.scope);
    out.Text(slot.name);
    out.Text(slot.type);
    out.Byte(slot.has_key ? kHasKey : 0);
  }
}

std::optional<TreeDescription> DecodeTree(Decoder in) {
  TreeDescription tree;
  tree.writer = in.Text();
  ListRoom room;
  tree.info = DecodeInfo(in, room);
  tree.main_tree = in.Text();
  for (std::size_t left = room.Begin(in, tree.documents); left > 0 && in.ok(); --left) {
    std::string file = in.Text();
    tree.documents.push_back({std::move(file), in.Text()});
  }
  tree.models = in.Text();
  const std::size_t nodes = room.Begin(in, tree.nodes);
  if (nodes > kMostNodes) in.Fail();
  for (std::size_t left = nodes; left > 0 && in.ok(); --left) {
    tree.nodes.push_back(DecodeNode(in, tree.documents.size(), room));
  }
  for (std::size_t left = room.Begin(in, tree.slots); left > 0 && in.ok(); --left) {
    tree.slots.push_back(DecodeSlot(in));
  }
  if (!in.ok() || !IsPreorder(tree.nodes) || !PortsHaveSlots(tree)) return std::nullopt;
  return WholeOrNothing(in, std::move(tree));
}

void EncodeStateHead(const HistoryState& state, Encoder& out) {
  out.Byte(static_cast<std::uint8_t>(state.cause));
  out.Unsigned(state.tick);
  out.At(state.time);
}

bool DecodeStateHead(Decoder& in, HistoryState& state) {
  constexpr std::size_t kCauses = 4;
  state.cause = static_cast<HistoryState::Cause>(in.Index(kCauses));
  state.tick = in.Unsigned();
  state.time = in.At();
  return in.ok();
}

void EncodeStateBody(const HistoryState& state, Encoder& out) {
  for (std::size_t i = 0; i < state.statuses.size(); ++i) {
    out.Byte(static_cast<std::uint8_t>(static_cast<unsigned>(state.statuses[i]) |
                                       static_cast<unsigned>(state.last[i]) << kLastShift));
  }
  std::size_t bytes = 0;
  for (const std::string& value : state.values) {
    const std::size_t limit = bytes > kMuchText ? kShortValueBytes : kMaxValueBytes;
    bytes += std::min(value.size(), limit);
    out.Text(CutValue(value, limit));
  }
}

bool DecodeStateBody(Decoder in, const TreeSize& size, HistoryState& state) {
  if (in.left() < size.nodes + size.slots) return false;
  state.statuses.clear();
  state.last.clear();
  state.values.clear();
  for (std::size_t i = 0; i < size.nodes; ++i) {
    const unsigned both = in.Byte();
    const unsigned now = both & 15;
    const unsigned last = both >> kLastShift;
    if (now >= kStatuses || last >= kStatuses) return false;
    state.statuses.push_back(static_cast<Status>(now));
    state.last.push_back(static_cast<Status>(last));
  }
  for (std::size_t i = 0; i < size.slots && in.ok(); ++i) state.values.push_back(in.Text());
  return in.ok() && in.at_end();
}

void EncodeGap(const HistoryGap& gap, Encoder& out) {
  out.Byte(static_cast<std::uint8_t>(gap.cause));
  out.At(gap.time);
  out.Unsigned(gap.lost_ticks);
  out.Unsigned(gap.first_tick);
  out.Unsigned(gap.last_tick);
  out.Unsigned(gap.lost_notes);
}

std::string MakeGapFrame(const HistoryGap& gap) {
  Bytes frame;
  OpenFrame(frame, FrameType::kGap);
  Encoder encoder(frame);
  EncodeGap(gap, encoder);
  CloseFrame(frame, 0);
  SealFrame(frame.data());
  return std::string(frame.begin(), frame.end());
}

std::optional<HistoryGap> DecodeGap(Decoder in) {
  HistoryGap gap;
  gap.cause = static_cast<HistoryGap::Cause>(in.Index(2));
  gap.time = in.At();
  gap.lost_ticks = in.Unsigned();
  gap.first_tick = in.Unsigned();
  gap.last_tick = in.Unsigned();
  gap.lost_notes = in.Unsigned();
  return WholeOrNothing(in, gap);
}

void EncodeNote(const HistoryNote& note, Encoder& out) {
  out.At(note.time);
  out.Text(CutText(note.kind));
  out.Text(CutText(note.text));
}

std::optional<HistoryNote> DecodeNote(Decoder in) {
  HistoryNote note;
  note.time = in.At();
  note.kind = in.Text();
  note.text = in.Text();
  return WholeOrNothing(in, std::move(note));
}

void EncodeEnd(const HistoryEnd& end, Encoder& out) {
  out.Byte(static_cast<std::uint8_t>(end.cause));
  out.At(end.time);
  out.Unsigned(end.tick);
}

std::optional<HistoryEnd> DecodeEnd(Decoder in) {
  HistoryEnd end;
  end.cause = static_cast<HistoryEnd::Cause>(in.Index(2));
  end.time = in.At();
  end.tick = in.Unsigned();
  return WholeOrNothing(in, end);
}

}  // namespace coppice
