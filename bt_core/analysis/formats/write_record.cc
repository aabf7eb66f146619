#include "bt_core/analysis/formats/write_record.h"

#include <optional>

#include "bt_core/frames/follower.h"
#include "bt_core/frames/frame.h"
#include "bt_core/frames/packer.h"
#include "bt_core/frames/payload_coding.h"

namespace coppice {
namespace {

constexpr std::size_t kEventsBytes = 32 << 10;     // of a frame of ticks, before packing
constexpr std::size_t kKeyframeBytes = 256 << 10;  // between two states

class RecordMaker {
 public:
  explicit RecordMaker(const Recording& run) : run_(run) { AppendPreamble(out_); }

  std::string Make() {
    std::size_t tree = SIZE_MAX;
    const auto& sections = run_.sections();
    for (std::size_t i = 0; i < sections.size(); ++i) {
      AddAsides(sections[i].first_tick);
      Flush();
      if (sections[i].tree != tree) AddTree(run_.trees()[tree = sections[i].tree]);
      follower_.emplace(ShapeOf(run_.trees()[tree]), sections[i].state);
      AddState(follower_->State(sections[i].state.cause));
      const bool is_last = i + 1 == sections.size();
      AddTicks(sections[i].first_tick, is_last ? run_.ticks().size() : sections[i + 1].first_tick);
    }
    AddAsides(run_.ticks().size());
    Flush();
    if (run_.end()) {
      AddFrame(FrameType::kEnd, [&](Encoder& out) { EncodeEnd(*run_.end(), out); });
    }
    return {out_.begin(), out_.end()};
  }

 private:
  template <class Encode>
  void AddFrame(FrameType type, Encode encode) {
    const std::size_t frame = OpenFrame(out_, type);
    Encoder encoder(out_);
    encode(encoder);
    CloseFrame(out_, frame);
    SealFrame(out_.data() + frame);
  }

  void AddTree(const TreeDescription& tree) {
    Bytes raw;
    Encoder encoder(raw);
    EncodeTree(tree, encoder);
    packer_.Restart();
    AddFrame(FrameType::kTree, [&](Encoder&) { packer_.Pack(raw, out_); });
  }

  void AddState(const HistoryState& state) {
    Bytes raw;
    Encoder body(raw);
    EncodeStateBody(state, body);
    packer_.Restart();
    AddFrame(FrameType::kState, [&](Encoder& head) {
      EncodeStateHead(state, head);
      packer_.Pack(raw, out_);
    });
    ticks_.Restart(state.tick, state.time);
    since_state_ = 0;
  }

  void AddTicks(std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      AddAsides(i);
      const TickEvents events = run_.EventsOf(i);
      const std::size_t before = raw_.size();
      ticks_.Encode(events, raw_);
      since_state_ += raw_.size() - before;
      follower_->Apply(events);
      if (raw_.size() >= kEventsBytes) Flush();
      if (since_state_ < kKeyframeBytes || !events.is_whole) continue;
      Flush();
      AddState(follower_->State(HistoryState::Cause::kKeyframe));
    }
  }

  // Gaps and notes that stand before a tick.
  void AddAsides(std::size_t tick) {
    for (; gap_ < run_.gaps().size() && run_.gaps()[gap_].tick <= tick; ++gap_) {
      Flush();
      AddFrame(FrameType::kGap, [&](Encoder& out) { EncodeGap(run_.gaps()[gap_].gap, out); });
    }
    for (; note_ < run_.notes().size() && run_.notes()[note_].tick <= tick; ++note_) {
      Flush();
      AddFrame(FrameType::kNote, [&](Encoder& out) { EncodeNote(run_.notes()[note_].note, out); });
    }
  }

  void Flush() {
    if (raw_.empty()) return;
    AddFrame(FrameType::kEvents, [&](Encoder&) { packer_.Pack(raw_, out_); });
    raw_.clear();
  }

  const Recording& run_;
  std::optional<HistoryFollower> follower_;
  TickEncoder ticks_;
  Packer packer_;
  Bytes out_;
  Bytes raw_;  // ticks that are in no frame yet
  std::size_t since_state_ = 0;
  std::size_t gap_ = 0;
  std::size_t note_ = 0;
};

}  // namespace

std::string ToRecord(const Recording& run) { return RecordMaker(run).Make(); }

}  // namespace coppice
