// Brings values of a tree's blackboard to another thread. The ticking thread copies them between
// two ticks, so they belong together; it is asked through the inbox and never waits.
#ifndef COPPICE_BT_CORE_LIVE_BOARD_COPIER_H_
#define COPPICE_BT_CORE_LIVE_BOARD_COPIER_H_

#include <memory>
#include <vector>

#include "bt_core/engine/executor.h"

namespace coppice {

class BoardCopier {
 public:
  /// On the ticking thread. Copies all values once, so that there is always something to show. The
  /// executor must outlive the copier.
  explicit BoardCopier(Executor& executor);
  ~BoardCopier();
  BoardCopier(const BoardCopier&) = delete;
  BoardCopier& operator=(const BoardCopier&) = delete;

  /// One other thread. All slots, of which those of the given scopes are fresh. If nobody ticks the
  /// tree for `patience`, those that came last; and until the tree is ticked again, at once.
  const std::vector<Value>& Copy(const std::vector<ScopeIndex>& scopes, Duration patience);

  /// Any thread: ends the waiting in Copy, for good.
  void Cancel();

 private:
  struct Exchange;

  void Ask(const std::vector<ScopeIndex>& scopes);
  void Take();

  Executor& executor_;
  std::shared_ptr<Exchange> exchange_;  // shared with the call that lies in the inbox
  std::vector<Value> values_;           // of the thread that asks
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_BOARD_COPIER_H_
