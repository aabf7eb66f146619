// The history that a client has got so far, over all its connections: where to go on, and what to
// tell the listener when it does not go on there.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_HISTORY_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_HISTORY_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/frames/history_decoder.h"
#include "bt_core/live/client/client_types.h"

namespace coppice {

class ClientHistory : private HistoryHandler {
 public:
  explicit ClientHistory(LiveListener& listener) : listener_(listener) {}

  const RunId& run() const { return run_; }
  /// The frame of this run that is wanted next; nothing if there is none yet.
  std::optional<std::uint64_t> next() const {
    return has_frames_ ? std::optional(next_) : std::nullopt;
  }

  /// Of the present tree; 0 if there is none yet.
  std::size_t nodes() const { return nodes_; }

  /// What follows is of this run; `first` is the frame that follows. True if it goes on where it
  /// was.
  bool Begin(const RunId& run, std::uint64_t first);

  /// One push: the number of its first frame, the number after the last one, and the frames.
  /// After a problem the connection must begin anew.
  Outcome Add(std::uint64_t first, std::uint64_t next, std::string_view frames);

 private:
  void OnTree(const TreeDescription& tree) override;
  void OnState(const HistoryState& state) override;
  void OnTick(const TickEvents& events) override;
  void OnGap(const HistoryGap& gap) override;
  void OnNote(const HistoryNote& note) override { listener_.OnNote(note); }
  void OnEnd(const HistoryEnd& end) override { listener_.OnEnd(end); }
  void TellHole(const HistoryState& state);

  LiveListener& listener_;
  HistoryDecoder decoder_;
  RunId run_{};
  std::size_t nodes_ = 0;
  bool has_frames_ = false;
  std::uint64_t next_ = 0;
  std::uint64_t tick_ = 0;  // the last one that came
  bool has_hole_ = false;   // something is missing before the next state
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_HISTORY_H_
