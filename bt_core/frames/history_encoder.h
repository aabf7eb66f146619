// Makes the frames of a history from what an EventStream hands out.
//
//   class Output : public FrameSink { void OnFrame(const Frame& frame) override {...} };
//   HistoryEncoder encoder(options, output);
//   encoder.Add(state);     // EventListener::OnState -> frames `tree` and `state`
//   encoder.Add(events);    // EventListener::OnTick: kept until
//   encoder.Flush();        // -> a frame `events`
//
// It follows the tree, so it can give its state at any time. All functions on one thread, or under
// one lock. Time and memory per call depend on the sizes of tick and tree only.
#ifndef COPPICE_BT_CORE_FRAMES_HISTORY_ENCODER_H_
#define COPPICE_BT_CORE_FRAMES_HISTORY_ENCODER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/frames/follower.h"
#include "bt_core/frames/frame.h"
#include "bt_core/frames/history.h"
#include "bt_core/frames/packer.h"
#include "bt_core/frames/tick_coding.h"

namespace coppice {

/// A frame that is ready to be written or sent.
struct Frame {
  FrameType type;
  const std::uint8_t* data;  ///< with its header; valid during the call only
  std::size_t size;
  std::uint64_t tick;  ///< number of the last tick that is in it or before it
  Time time;           ///< and its start, in the tree's clock
};

class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void OnFrame(const Frame& frame) = 0;
};

struct HistoryOptions {
  RunInfo info;
  /// Raw bytes of events after which a state is put in. The larger of the two counts.
  std::size_t keyframe_bytes = 256 << 10;
  std::size_t keyframe_states = 4;  ///< sizes of a state
  /// Raw bytes of events after which they become a frame by themselves.
  std::size_t frame_bytes = 32 << 10;
};

class HistoryEncoder {
 public:
  HistoryEncoder(HistoryOptions options, FrameSink& sink);

  /// The first state, and what comes after a gap or a jump. A program that is not the one before is
  /// described first.
  void Add(const StreamState& state);
  /// The same for a tree that runs elsewhere, described by others.
  void Add(TreeDescription tree, const HistoryState& state);
  void Add(const TickEvents& events);

  /// Instead of Add for what finds no room: the tree is followed, the tick is counted. The next
  /// Add, Note, Begin or End says what is missing and how the tree stands.
  void Skip(const StreamState& state);
  void Skip(const TickEvents& events);

  /// Stands behind all ticks so far.
  void Note(const HistoryNote& note);
  /// Notes that found no room. Said as Skip's are.
  void SkipNotes(std::uint64_t count) { gap_.lost_notes += count; }

  /// Makes a frame of the events that are not in one yet.
  void Flush();
  /// Raw bytes of these events.
  std::size_t unflushed() const { return raw_.size(); }

  /// Puts in the state: reading can begin here. Nothing happens between the parts of a tick that
  /// stands at a breakpoint, since no state can be told there.
  void Keyframe();

  /// Puts in tree and state: another file begins here. Not between the parts of a tick.
  void Begin();

  void End(HistoryEnd::Cause cause, Time time);

  /// What the frames so far amount to. Null before the first state.
  const HistoryFollower* follower() const;
  const TreeDescription& tree() const { return tree_; }

 private:
  static HistoryState::Cause CauseOf(const StreamState& state);
  void Follow(const StreamState& state);
  void Follow(const TickEvents& events);
  void CountLost(const StreamState& state);
  void CountLost(std::uint64_t first, std::uint64_t last, std::uint64_t count);
  bool HasGap() const { return gap_.lost_ticks > 0 || gap_.lost_notes > 0; }
  void PayDebts();
  void EmitGap();
  void EmitTree();
  void EmitState(HistoryState::Cause cause);
  void Open(FrameType type);
  void Emit();

  HistoryOptions options_;
  FrameSink& sink_;
  std::shared_ptr<const Program> program_;
  TreeDescription tree_;
  mutable std::optional<HistoryFollower> follower_;  // settled when somebody asks
  TickEncoder ticks_;
  Packer packer_;
  HistoryGap gap_;            // what is missing and not said yet
  bool owes_tree_ = false;    // a reader does not know it yet
  bool owes_state_ = false;   // nor how it stands
  bool within_tick_ = false;  // the rest of it follows
  bool is_settled_ = false;   // events like those of the last tick change nothing
  Bytes raw_;                 // ticks that are in no frame yet
  Bytes frame_;
  std::size_t since_keyframe_ = 0;  // raw bytes
  std::size_t keyframe_every_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_HISTORY_ENCODER_H_
