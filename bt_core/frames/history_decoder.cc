#include "bt_core/frames/history_decoder.h"

#include <utility>

#include "bt_core/frames/payload_coding.h"

namespace coppice {
namespace {

constexpr char kNonsense[] = "a frame does not make sense";

template <class T, class Call>
Outcome HandOver(const std::optional<T>& value, Call call) {
  if (!value) return Problem{kNonsense};
  call(*value);
  return {};
}

}  // namespace

void HistoryDecoder::SetTree(const TreeSize& size) {
  size_ = size;
  has_tree_ = true;
  follows_ = false;
}

Outcome HistoryDecoder::Decode(const std::uint8_t* frame, std::size_t size,
                               HistoryHandler& handler) {
  Outcome decoded = DecodeFrame(frame, size, handler);
  if (!decoded) Forget();
  return decoded;
}

Outcome HistoryDecoder::DecodeFrame(const std::uint8_t* frame, std::size_t size,
                                    HistoryHandler& handler) {
  if (size < kFrameHeaderSize) return Problem{"a frame is cut off"};
  const FrameHeader header = ReadFrameHeader(frame);
  if (!IsPlausible(header) || header.payload_size != size - kFrameHeaderSize) {
    return Problem{kNonsense};
  }
  if (!IsWhole(frame, header)) return Problem{"the checksum of a frame is wrong"};
  const Decoder payload(frame + kFrameHeaderSize, frame + size);
  switch (static_cast<FrameType>(header.type)) {
    case FrameType::kTree:
      return TakeTree(payload, handler);
    case FrameType::kState:
      return TakeState(payload, handler);
    case FrameType::kEvents:
      return TakeEvents(payload, handler);
    case FrameType::kGap:
      return HandOver(DecodeGap(payload), [&](const HistoryGap& gap) { handler.OnGap(gap); });
    case FrameType::kNote:
      return HandOver(DecodeNote(payload), [&](const HistoryNote& note) { handler.OnNote(note); });
    case FrameType::kEnd:
      return HandOver(DecodeEnd(payload), [&](const HistoryEnd& end) { handler.OnEnd(end); });
  }
  return Problem{kNonsense};
}

bool HistoryDecoder::Unpack(const Decoder& packed) {
  raw_.clear();
  return unpacker_.Unpack(packed.at(), packed.left(), kMaxRawSize, raw_);
}

Outcome HistoryDecoder::TakeTree(Decoder payload, HistoryHandler& handler) {
  has_tree_ = false;
  follows_ = false;
  unpacker_.Restart();
  if (!Unpack(payload)) return Problem{"the description of a tree cannot be unpacked"};
  const std::optional<TreeDescription> tree =
      DecodeTree(Decoder(raw_.data(), raw_.data() + raw_.size()));
  if (!tree) return Problem{"the description of a tree does not make sense"};
  SetTree({tree->nodes.size(), tree->slots.size()});
  handler.OnTree(*tree);
  return {};
}

Outcome HistoryDecoder::TakeState(Decoder payload, HistoryHandler& handler) {
  if (!has_tree_) return Problem{"a state without a tree"};
  HistoryState state;
  unpacker_.Restart();
  if (!DecodeStateHead(payload, state) || !Unpack(payload) ||
      !DecodeStateBody(Decoder(raw_.data(), raw_.data() + raw_.size()), size_, state)) {
    return Problem{"a state does not make sense"};
  }
  ticks_.Restart(state.tick, state.time);
  follows_ = true;
  handler.OnState(state);
  return {};
}

Outcome HistoryDecoder::TakeEvents(Decoder payload, HistoryHandler& handler) {
  if (!follows_) return Problem{"events without the state before them"};
  if (!Unpack(payload)) return Problem{"events cannot be unpacked"};
  Decoder in(raw_.data(), raw_.data() + raw_.size());
  for (std::size_t ticks = 0; !in.at_end(); ++ticks) {
    if (ticks == kMaxTicksInFrame) return Problem{"more ticks than a frame can have"};
    const std::optional<TickEvents> tick = ticks_.Decode(in, size_);
    if (!tick) return Problem{"a tick does not make sense"};
    handler.OnTick(*tick);
  }
  return {};
}

}  // namespace coppice
