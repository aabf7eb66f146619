#include <algorithm>
#include <cstdlib>
#include <optional>

#include "bt_core/history/follower.h"
#include "bt_core/history/history_decoder.h"
#include "bt_core/history/packer.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

void Require(bool condition) {
  if (!condition) std::abort();
}

// Follows what it is told, and looks whether that is possible.
class Follower final : public HistoryHandler {
 public:
  void OnTree(const TreeDescription& tree) override {
    nodes_ = tree.nodes.size();
    slots_ = tree.slots.size();
    shape_ = ShapeOf(tree);
    Require(nodes_ > 0 && shape_[0].end == nodes_);
    follower_.reset();
  }
  void OnState(const HistoryState& state) override {
    Require(state.statuses.size() == nodes_ && state.last.size() == nodes_);
    Require(state.values.size() == slots_);
    follower_.emplace(shape_, state);
  }
  void OnTick(const TickEvents& events) override {
    Require(follower_.has_value());
    ++ticks_;
    follower_->Apply(
        events, [](const StatusChange&) {}, [this](const Event& event) { Check(event); });
  }

  int reached() const { return ticks_ > 0 ? 3 : follower_ ? 2 : nodes_ > 0 ? 1 : 0; }

 private:
  void Check(const Event& event) const {
    const bool is_slot = event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
    Require(event.index < (is_slot ? slots_ : nodes_));
    Require(event.writer == kNoNode || event.writer < nodes_);
  }

  std::size_t nodes_ = 0;
  std::size_t slots_ = 0;
  TreeShape shape_;
  std::optional<HistoryFollower> follower_;
  int ticks_ = 0;
};

// The whole of a state is not packed: its cause, tick and time stand before.
std::size_t PlainBytes(FrameType type, std::size_t size) {
  constexpr std::size_t kHead = 3;
  if (type == FrameType::kState) return std::min(kHead, size);
  return type == FrameType::kTree || type == FrameType::kEvents ? 0 : size;
}

Bytes MakeFrame(FrameType type, std::string_view payload, Packer& packer) {
  Bytes frame;
  OpenFrame(frame, type);
  const std::size_t plain = PlainBytes(type, payload.size());
  frame.insert(frame.end(), payload.begin(), payload.begin() + static_cast<long>(plain));
  if (type == FrameType::kTree || type == FrameType::kState) packer.Restart();
  if (plain < payload.size()) {
    packer.Pack(Bytes(payload.begin() + static_cast<long>(plain), payload.end()), frame);
  }
  CloseFrame(frame, 0);
  SealFrame(frame.data());
  return frame;
}

}  // namespace

int FuzzHistory(std::string_view bytes) {
  constexpr std::size_t kHead = 3;
  HistoryDecoder decoder;
  HistoryDecoder wild;  // gets the bytes as they are
  Packer packer;
  Follower follower;
  Follower wild_follower;
  while (bytes.size() >= kHead) {
    const auto type = static_cast<unsigned char>(bytes[0]);
    const std::size_t size = std::min<std::size_t>(
        static_cast<unsigned char>(bytes[1]) | static_cast<unsigned char>(bytes[2]) << 8,
        bytes.size() - kHead);
    const std::string_view payload = bytes.substr(kHead, size);
    const Bytes frame = MakeFrame(static_cast<FrameType>(type), payload, packer);
    const std::string problem = decoder.Decode(frame.data(), frame.size(), follower);
    if (!problem.empty()) Require(!decoder.follows());
    wild.Decode(reinterpret_cast<const std::uint8_t*>(payload.data()), size, wild_follower);
    bytes.remove_prefix(kHead + size);
  }
  return follower.reached();
}

}  // namespace coppice::fuzz
