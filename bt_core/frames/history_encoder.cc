#include "bt_core/frames/history_encoder.h"

#include <algorithm>
#include <utility>

#include "bt_core/frames/payload_coding.h"

namespace coppice {

HistoryEncoder::HistoryEncoder(HistoryOptions options, FrameSink& sink)
    : options_(std::move(options)), sink_(sink) {}

void HistoryEncoder::Add(const StreamState& state) {
  Flush();
  if (HasGap()) EmitGap();
  CountLost(state);
  if (HasGap()) EmitGap();
  Follow(state);
  if (owes_tree_) EmitTree();
  EmitState(CauseOf(state));
}

void HistoryEncoder::Add(TreeDescription tree, const HistoryState& state) {
  Flush();
  if (HasGap()) EmitGap();
  program_.reset();
  tree_ = std::move(tree);
  follower_.emplace(ShapeOf(tree_), state);
  within_tick_ = false;
  EmitTree();
  EmitState(state.cause);
}

void HistoryEncoder::Skip(const StreamState& state) {
  CountLost(state);
  Follow(state);
  owes_state_ = true;
}

void HistoryEncoder::CountLost(const StreamState& state) {
  if (state.lost_ticks == 0) return;
  CountLost(state.first_lost, state.last_lost, state.lost_ticks);
  gap_.cause = HistoryGap::Cause::kStream;
}

void HistoryEncoder::CountLost(std::uint64_t first, std::uint64_t last, std::uint64_t count) {
  if (gap_.lost_ticks == 0) gap_.first_tick = first;
  gap_.lost_ticks += count;
  gap_.last_tick = last;
  owes_state_ = true;
}

void HistoryEncoder::Follow(const StreamState& state) {
  HistoryState now{CauseOf(state), state.tick, state.time, state.statuses, {}, state.values};
  if (state.program == program_) {
    now.last = follower_->LastsWith(state.statuses);
    follower_->Set(now);
  } else {
    program_ = state.program;
    tree_ = DescribeTree(*program_, options_.info);
    follower_.emplace(ShapeOf(*program_), now);
    owes_tree_ = true;
  }
  within_tick_ = false;
}

HistoryState::Cause HistoryEncoder::CauseOf(const StreamState& state) {
  switch (state.cause) {
    case StreamState::Cause::kLost:
      return HistoryState::Cause::kLost;
    case StreamState::Cause::kJump:
      return HistoryState::Cause::kJump;
    case StreamState::Cause::kBegin:
      break;
  }
  return HistoryState::Cause::kBegin;
}

void HistoryEncoder::Add(const TickEvents& events) {
  if (!follower_) return;
  if (owes_state_ && within_tick_) return Skip(events);  // a state within a tick helps nobody
  if (owes_state_ || HasGap()) PayDebts();
  const std::size_t before = raw_.size();
  ticks_.Encode(events, raw_);
  Follow(events);
  within_tick_ = !events.is_whole;
  since_keyframe_ += raw_.size() - before;
  if (within_tick_) return;
  if (since_keyframe_ >= keyframe_every_) {
    Keyframe();
  } else if (raw_.size() >= options_.frame_bytes) {
    Flush();
  }
}

void HistoryEncoder::Follow(const TickEvents& events) {
  if (ticks_.repetitions() == 0) {
    follower_->Note(events);
    is_settled_ = false;
  } else if (is_settled_) {
    follower_->Pass(events);
  } else {
    is_settled_ = follower_->ApplyAgain(events);
  }
}

void HistoryEncoder::Skip(const TickEvents& events) {
  if (!follower_) return;
  follower_->Note(events);
  within_tick_ = !events.is_whole;
  gap_.cause = HistoryGap::Cause::kOutput;
  CountLost(events.tick, events.tick, events.is_whole ? 1 : 0);
}

void HistoryEncoder::Note(const HistoryNote& note) {
  PayDebts();
  Open(FrameType::kNote);
  Encoder encoder(frame_);
  EncodeNote(note, encoder);
  Emit();
}

void HistoryEncoder::Flush() {
  if (raw_.empty()) return;
  Open(FrameType::kEvents);
  packer_.Pack(raw_, frame_);
  raw_.clear();
  Emit();
}

void HistoryEncoder::Keyframe() {
  if (!follower_ || within_tick_) return;
  PayDebts();
  EmitState(HistoryState::Cause::kKeyframe);
}

void HistoryEncoder::Begin() {
  if (!follower_) return;
  PayDebts();
  EmitTree();
  EmitState(HistoryState::Cause::kKeyframe);
}

void HistoryEncoder::End(HistoryEnd::Cause cause, Time time) {
  PayDebts();
  Open(FrameType::kEnd);
  Encoder encoder(frame_);
  EncodeEnd({cause, time, follower_ ? follower_->tick() : 0}, encoder);
  Emit();
}

void HistoryEncoder::PayDebts() {
  Flush();
  if (HasGap()) EmitGap();
  if (within_tick_) return;
  if (owes_tree_) EmitTree();
  if (owes_state_) EmitState(HistoryState::Cause::kLost);
}

void HistoryEncoder::EmitGap() {
  gap_.time = follower_ ? follower_->time() : Time{};
  Open(FrameType::kGap);
  Encoder encoder(frame_);
  EncodeGap(gap_, encoder);
  Emit();
  gap_ = HistoryGap();
}

void HistoryEncoder::EmitTree() {
  Bytes raw;
  Encoder encoder(raw);
  EncodeTree(tree_, encoder);
  Open(FrameType::kTree);
  packer_.Restart();
  packer_.Pack(raw, frame_);
  Emit();
  owes_tree_ = false;
}

const HistoryFollower* HistoryEncoder::follower() const {
  if (!follower_) return nullptr;
  follower_->Settle();
  return &*follower_;
}

// The state begins a stream that the ticks behind it go on with.
void HistoryEncoder::EmitState(HistoryState::Cause cause) {
  const HistoryState state = follower()->State(cause);
  Bytes raw;
  Encoder body(raw);
  EncodeStateBody(state, body);
  Open(FrameType::kState);
  Encoder head(frame_);
  EncodeStateHead(state, head);
  packer_.Restart();
  packer_.Pack(raw, frame_);
  Emit();
  ticks_.Restart(state.tick, state.time);
  since_keyframe_ = 0;
  keyframe_every_ = std::max(options_.keyframe_bytes, options_.keyframe_states * raw.size());
  owes_state_ = false;
}

void HistoryEncoder::Open(FrameType type) {
  frame_.clear();
  OpenFrame(frame_, type);
}

void HistoryEncoder::Emit() {
  CloseFrame(frame_, 0);
  SealFrame(frame_.data());
  const auto type = static_cast<FrameType>(ReadFrameHeader(frame_.data()).type);
  sink_.OnFrame({type, frame_.data(), frame_.size(), follower_ ? follower_->tick() : 0,
                 follower_ ? follower_->time() : Time{}});
}

}  // namespace coppice
