// The past of a tree as frames (bt_core/frames), for clients that come later or come back:
// numbered from 0, as many as a limit of memory allows. It always begins where reading can begin.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_FRAME_STORE_H_
#define COPPICE_BT_CORE_LIVE_SERVER_FRAME_STORE_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "bt_core/base/clock.h"
#include "bt_core/frames/frame.h"

namespace coppice {

struct StoredFrame {
  FrameType type = FrameType::kTree;
  std::uint64_t tick = 0;  ///< number of the last tick that is in it or before it
  Time time{};             ///< and its start, in the tree's clock
  std::string bytes;
};

class FrameStore {
 public:
  explicit FrameStore(std::size_t limit) : limit_(limit) {}

  /// The memory that a frame takes, with what the allocator adds.
  static std::size_t CostOf(const StoredFrame& frame);

  /// Appends a frame. What is too old goes, up to a state; the youngest state stays, whatever the
  /// limit.
  void Add(StoredFrame frame);

  /// The numbers that are kept: first() .. next() - 1.
  std::uint64_t first() const { return first_; }
  std::uint64_t next() const { return first_ + frames_.size(); }
  const StoredFrame& operator[](std::uint64_t number) const { return frames_[number - first_]; }

  /// Where somebody begins who knows nothing: with TreeAt of a state, then from that state on. Only
  /// if there is one (has_entry).
  std::uint64_t oldest_state() const { return first_state_; }
  std::uint64_t youngest_state() const { return last_state_; }
  bool has_entry() const { return has_entry_; }

  /// The description of the tree that holds at a frame.
  const StoredFrame& TreeAt(std::uint64_t number) const;

 private:
  void Trim();
  void DropFirst();

  const std::size_t limit_;
  std::deque<StoredFrame> frames_;
  std::uint64_t first_ = 0;
  std::size_t size_ = 0;
  bool has_entry_ = false;
  std::uint64_t first_state_ = 0;
  std::uint64_t last_state_ = 0;
  StoredFrame tree_;                 // that of the time before the first frame
  std::deque<std::uint64_t> trees_;  // the numbers of later ones
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_FRAME_STORE_H_
