#include "robot_app/slam/map/memory.h"

namespace coppice::robot::slam {

void Memory::Add() {
  used_.push_back(++now_);
  is_working_.push_back(true);
  ++working_;
}

MemoryChange Memory::Use(const std::vector<std::uint32_t>& key_frames, std::size_t most_retrieved) {
  MemoryChange change;
  ++now_;
  for (const std::uint32_t key_frame : key_frames) {
    if (is_working_[key_frame]) {
      used_[key_frame] = now_;
    } else if (change.retrieved.size() < most_retrieved) {
      used_[key_frame] = now_;
      is_working_[key_frame] = true;
      ++working_;
      change.retrieved.push_back(key_frame);
    }
  }
  while (working_ > most_) {
    std::uint32_t oldest = 0;
    for (std::uint32_t i = 0; i < used_.size(); ++i) {
      if (is_working_[i] && (!is_working_[oldest] || used_[i] < used_[oldest])) oldest = i;
    }
    is_working_[oldest] = false;
    --working_;
    change.forgotten.push_back(oldest);
  }
  return change;
}

}  // namespace coppice::robot::slam
