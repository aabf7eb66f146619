#include "bt_core/live/server/frame_store.h"

#include <utility>

namespace coppice {

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
  size_ += frame.bytes.size();
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
  size_ -= frames_.front().bytes.size();
  frames_.pop_front();
  ++first_;
}

}  // namespace coppice
