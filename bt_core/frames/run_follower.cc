#include "bt_core/frames/run_follower.h"

namespace coppice {

void RunFollower::Set(const HistoryState& state) {
  if (follower_) {
    follower_->Set(state);
  } else {
    follower_.emplace(ShapeOf(tree_), state);
  }
}

}  // namespace coppice
