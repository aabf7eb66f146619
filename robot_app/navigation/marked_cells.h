// Cells of a grid that were marked, and when.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_MARKED_CELLS_H_
#define COPPICE_ROBOT_APP_NAVIGATION_MARKED_CELLS_H_

#include <algorithm>
#include <vector>

#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::navigation {

/// Marking is of constant time, all else linear in the number of marks. Not thread-safe.
class MarkedCells {
 public:
  /// Starts empty on a grid.
  void Reset(const GridFrame& frame) {
    frame_ = frame;
    seen_.assign(static_cast<std::size_t>(frame.size()), kNever);
    list_.clear();
  }
  const GridFrame& frame() const { return frame_; }

  /// A cell that is marked already gets the newer time.
  void Mark(int index, double time) {
    if (list_.empty()) since_ = time;
    if (!Marked(index)) list_.push_back(index);
    seen_[index] = static_cast<float>(time - since_);
  }
  bool Marked(int index) const { return seen_[index] != kNever; }
  /// In no particular order, each once.
  const std::vector<int>& list() const { return list_; }

  /// Takes a mark away. Many go at once: list() is right again after the next KeepIf(), which comes
  /// before the next Mark().
  void Unmark(int index) { seen_[index] = kNever; }

  /// Drops the marks for which `keep(index)` is false.
  template <typename Keep>
  void KeepIf(Keep keep) {
    const auto gone = std::remove_if(list_.begin(), list_.end(), [&](int index) {
      if (Marked(index) && keep(index)) return false;
      seen_[index] = kNever;
      return true;
    });
    list_.erase(gone, list_.end());
  }
  /// Drops the marks that are older than `age` at `now` [s].
  void Forget(double now, double age) {
    KeepIf([&](int index) { return now - since_ - seen_[index] <= age; });
  }
  void Clear() {
    KeepIf([](int) { return false; });
  }

 private:
  static constexpr float kNever = -1e30F;

  GridFrame frame_;
  double since_ = 0;         // when the first one was marked [s]
  std::vector<float> seen_;  // per cell: when it was last marked, since then; maps are large
  std::vector<int> list_;
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_MARKED_CELLS_H_
