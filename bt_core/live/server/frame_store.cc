#include "bt_core/live/server/frame_store.h"

#include <algorithm>
#include <iterator>
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

const StoredFrame& FrameStore::TreeAt(std::uint64_t number) const {
  const auto later = std::upper_bound(trees_.begin(), trees_.end(), number);
  return later == trees_.begin() ? tree_ : (*this)[*std::prev(later)];
}

void FrameStore::Add(StoredFrame frame) {
  if (frame.type == FrameType::kTree) trees_.push_back(next());
  if (frame.type == FrameType::kState) {
    last_state_ = next();
    if (!std::exchange(has_entry_, true)) first_state_ = last_state_;
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
  size_ -= CostOf(frames_.front());
  if (frames_.front().type == FrameType::kTree) {
    tree_ = std::move(frames_.front());
    trees_.pop_front();
  }
  frames_.pop_front();
  ++first_;
}

}  // namespace coppice
