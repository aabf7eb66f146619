// Follows a history and looks whether that is possible: whoever shows one to people, or stores it,
// indexes arrays with what it is told.
#ifndef COPPICE_TESTS_FUZZ_HISTORY_CHECK_H_
#define COPPICE_TESTS_FUZZ_HISTORY_CHECK_H_

#include <optional>

#include "bt_core/frames/follower.h"

namespace coppice::fuzz {

/// Aborts if the condition does not hold, which is what a fuzzer finds.
void Require(bool condition);

class HistoryCheck {
 public:
  void OnTree(const TreeDescription& tree);
  void OnState(const HistoryState& state);
  void OnTick(const TickEvents& events);

  /// 0 no tree, 1 no state, 2 no tick, 3.
  int reached() const { return ticks_ > 0 ? 3 : follower_ ? 2 : nodes_ > 0 ? 1 : 0; }
  std::size_t nodes() const { return nodes_; }

 private:
  void Check(const Event& event) const;

  std::size_t nodes_ = 0;
  std::size_t slots_ = 0;
  TreeShape shape_;
  std::optional<HistoryFollower> follower_;
  int ticks_ = 0;
};

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_HISTORY_CHECK_H_
