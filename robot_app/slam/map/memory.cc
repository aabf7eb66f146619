#include "robot_app/slam/map/memory.h"

#include <tuple>
#include <unordered_map>

namespace coppice::robot::slam {

void Memory::Add() {
  used_.push_back(++now_);
  is_working_.push_back(true);
  ++working_;
}

MemoryChange Memory::Use(const std::vector<std::uint32_t>& key_frames, std::size_t enough,
                         std::size_t most_retrieved,
                         const std::function<std::uint64_t(std::uint32_t)>& place_of) {
  MemoryChange change;
  ++now_;
  std::size_t in_use = 0;
  for (const std::uint32_t key_frame : key_frames) {
    if (!is_working_[key_frame]) continue;
    used_[key_frame] = now_;
    ++in_use;
  }
  for (const std::uint32_t key_frame : key_frames) {
    if (in_use >= enough || change.retrieved.size() >= most_retrieved) break;
    if (is_working_[key_frame]) continue;
    used_[key_frame] = now_;
    is_working_[key_frame] = true;
    ++working_;
    ++in_use;
    change.retrieved.push_back(key_frame);
  }
  while (working_ > most_) {
    const std::uint32_t spare = Spare(place_of);
    PutBack(spare);
    change.forgotten.push_back(spare);
  }
  return change;
}

void Memory::PutBack(std::uint32_t key_frame) {
  if (!is_working_[key_frame]) return;
  is_working_[key_frame] = false;
  --working_;
}

// Not in use now, if there is any; of the place of which most is known; unused for the longest
// time.
std::uint32_t Memory::Spare(const std::function<std::uint64_t(std::uint32_t)>& place_of) const {
  std::unordered_map<std::uint64_t, int> known;
  for (std::uint32_t i = 0; i < used_.size(); ++i) {
    if (is_working_[i]) ++known[place_of(i)];
  }
  std::uint32_t spare = 0;
  std::tuple<bool, int, std::uint64_t> least{true, 1, 0};
  for (std::uint32_t i = 0; i < used_.size(); ++i) {
    if (!is_working_[i]) continue;
    const std::tuple<bool, int, std::uint64_t> of_this{used_[i] == now_, -known[place_of(i)],
                                                       used_[i]};
    if (of_this >= least) continue;
    spare = i;
    least = of_this;
  }
  return spare;
}

}  // namespace coppice::robot::slam
