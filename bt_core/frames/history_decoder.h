// Takes the frames of a history apart. Any bytes may be handed in: what is no sense is refused.
//
//   HistoryDecoder decoder;
//   const Outcome decoded = decoder.Decode(data, size, handler);   // calls of the handler
#ifndef COPPICE_BT_CORE_FRAMES_HISTORY_DECODER_H_
#define COPPICE_BT_CORE_FRAMES_HISTORY_DECODER_H_

#include <cstddef>
#include <cstdint>
#include <optional>

#include "bt_core/base/outcome.h"
#include "bt_core/frames/frame.h"
#include "bt_core/frames/history.h"
#include "bt_core/frames/packer.h"
#include "bt_core/frames/tick_coding.h"

namespace coppice {

class HistoryDecoder {
 public:
  /// One whole frame with its header. After a problem, and at the start, events are refused until a
  /// state has come: they build on what was before them. A state needs a tree.
  Outcome Decode(const std::uint8_t* frame, std::size_t size, HistoryHandler& handler);

  /// Frames are missing, or are skipped to go on elsewhere: the next one must be a state, or one
  /// that stands for itself.
  void Forget() { follows_ = false; }

  /// Whether events can be understood now.
  bool follows() const { return follows_; }

  /// Goes on behind a tree that was decoded elsewhere.
  void SetTree(const TreeSize& size);

 private:
  Outcome DecodeFrame(const std::uint8_t* frame, std::size_t size, HistoryHandler& handler);
  Outcome TakeTree(Decoder payload, HistoryHandler& handler);
  Outcome TakeState(Decoder payload, HistoryHandler& handler);
  Outcome TakeEvents(Decoder payload, HistoryHandler& handler);
  bool Unpack(const Decoder& packed);

  bool has_tree_ = false;
  bool follows_ = false;
  TreeSize size_;
  TickDecoder ticks_;
  Unpacker unpacker_;
  Bytes raw_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_HISTORY_DECODER_H_
