// The tree of a history and how it stands, whatever tree comes: for those who handle a history.
#ifndef COPPICE_BT_CORE_FRAMES_RUN_FOLLOWER_H_
#define COPPICE_BT_CORE_FRAMES_RUN_FOLLOWER_H_

#include <optional>

#include "bt_core/frames/follower.h"

namespace coppice {

class RunFollower {
 public:
  void Set(const TreeDescription& tree) {
    tree_ = tree;
    follower_.reset();
  }
  void Set(const HistoryState& state);
  /// Ticks before the first state of a tree are passed over, and nothing is called.
  template <class... Calls>
  void Apply(const TickEvents& events, const Calls&... calls) {
    if (follower_) follower_->Apply(events, calls...);
  }

  const TreeDescription& tree() const { return tree_; }
  /// Null before the first state of the tree.
  const HistoryFollower* state() const { return follower_ ? &*follower_ : nullptr; }
  HistoryFollower* state() { return follower_ ? &*follower_ : nullptr; }

 private:
  TreeDescription tree_;
  std::optional<HistoryFollower> follower_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_RUN_FOLLOWER_H_
