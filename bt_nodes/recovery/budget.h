// So many per so long: a limit on how often something is done.
#ifndef COPPICE_BT_NODES_RECOVERY_BUDGET_H_
#define COPPICE_BT_NODES_RECOVERY_BUDGET_H_

#include <algorithm>
#include <vector>

#include "bt_core/base/clock.h"

namespace coppice::leaves {

class Budget {
 public:
  /// Takes one if there is one left: fewer than `times` in the `period` before now.
  bool Take(Time now, int times, Duration period) {
    Forget(now, period);
    if (static_cast<int>(taken_.size()) >= times) return false;
    taken_.push_back(now);
    return true;
  }

  /// How many were taken in the `period` before now.
  int used(Time now, Duration period) {
    Forget(now, period);
    return static_cast<int>(taken_.size());
  }

 private:
  void Forget(Time now, Duration period) {
    const auto is_old = [&](Time time) { return now - time >= period; };
    taken_.erase(std::remove_if(taken_.begin(), taken_.end(), is_old), taken_.end());
  }

  std::vector<Time> taken_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_RECOVERY_BUDGET_H_
