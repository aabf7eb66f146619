#include "bt_core/live/server/frame_store.h"

#include <utility>

namespace coppice {

// Short bytes lie in the string itself. The allocator of glibc keeps a size with every block and
// rounds up to 16.
std::size_t FrameStore::CostOf(const StoredFrame& frame) {
  static const std::size_t inside = std::string().capacity();
  const std::size_t capacity = frame.bytes.capacity();
  if (capacity <= inside) return sizeof(StoredFrame);
  constexpr std::size_t kUnit = 16;
  const std::size_t block = capacity + 1 + sizeof(std::size_t);
  return sizeof(StoredFrame) + (block + kUnit - 1) / kUnit * kUnit;
}

void FrameStore::Add(StoredFrame frame) {
  if (frame.type == FrameType::kTree) last_tree_ = frame;
  if (frame.type == FrameType::kState) {
    last_state_ = next();
    if (!has_entry_) {
      has_entry_ = true;
      first_state_ = last_state_;
      tree_ = last_tree_;
    }
  }
  frame.bytes.shrink_to_fit();
  size_ += CostOf(frame);
  frames_.push_back(std::move(frame));
  Trim();
}

void FrameStore::Trim() {
  while (size_ > limit_ && first_state_ < last_state_) {
    while (first_ <= first_state_) DropFirst();
    while (frames_.front().type != FrameType::kState) DropFirst();
    first_state_ = first_;
  }
}

void FrameStore::DropFirst() {
  if (frames_.front().type == FrameType::kTree) tree_ = frames_.front();
  size_ -= CostOf(frames_.front());
  frames_.pop_front();
  ++first_;
}

}  // namespace coppice
