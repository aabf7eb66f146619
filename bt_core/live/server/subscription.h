// One client that follows one tree: which frames it gets next, and how many it may be sent before
// it has acknowledged what it has.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_SUBSCRIPTION_H_
#define COPPICE_BT_CORE_LIVE_SERVER_SUBSCRIPTION_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "bt_core/frames/history.h"
#include "bt_core/live/server/frame_store.h"

namespace coppice {

/// One message of frames.
struct Push {
  std::uint64_t first = 0;  ///< number of its first frame
  std::uint64_t next = 0;   ///< number after its last one; `first` if it has only unnumbered ones
  std::string frames;       ///< none: what is next is larger than the room that there is
};

class Subscription {
 public:
  static constexpr std::size_t kDefaultWindow = 4 << 20;
  static constexpr std::size_t kMaxWindow = 64 << 20;

  enum class From : std::uint8_t { kNumber, kOldest, kYoungest };

  /// `number`: with kNumber, the frame that the client wants next. The store has an entry.
  Subscription(const FrameStore& store, From from, std::uint64_t number, std::size_t window);

  /// What to send now; nothing if there is nothing new or the client must acknowledge first.
  /// `room`: the most bytes of frames that it may have.
  std::optional<Push> Next(const FrameStore& store, std::size_t room = SIZE_MAX);

  /// The client has used everything before this number.
  void Acknowledge(std::uint64_t next);

  /// The frame that follows those that were handed out.
  std::uint64_t next() const { return next_; }
  /// Frames that were kept no longer when it began.
  std::uint64_t missed() const { return missed_; }

 private:
  struct Sent {
    std::uint64_t next;
    std::size_t bytes;
  };

  void Enter(std::uint64_t state);
  void CrossHole(const FrameStore& store);
  std::size_t LeastBytes(const FrameStore& store) const;
  std::string Unnumbered(const FrameStore& store) const;

  const std::size_t window_;
  std::uint64_t next_ = 0;
  std::uint64_t missed_ = 0;
  std::uint64_t tick_ = 0;         // the last one that the client knows of
  bool needs_tree_ = false;        // before the next frame: the one that holds there
  std::optional<HistoryGap> gap_;  // to be told before that tree
  std::deque<Sent> sent_;          // and not acknowledged
  std::size_t in_flight_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_SUBSCRIPTION_H_
