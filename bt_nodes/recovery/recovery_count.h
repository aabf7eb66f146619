// How often which recovery was tried and how often it helped: the table of a deployment.
#ifndef COPPICE_BT_NODES_RECOVERY_RECOVERY_COUNT_H_
#define COPPICE_BT_NODES_RECOVERY_RECOVERY_COUNT_H_

#include <string>
#include <vector>

#include "bt_nodes/recovery/recovery_log.h"

namespace coppice::leaves {

/// The recoveries of one name.
struct RecoveryCount {
  std::string recovery;  ///< "wait and retry"
  int begun = 0;
  int succeeded = 0;        ///< carried out, and the fault was gone at their end
  int helped = 0;           ///< by the paper's criterion (recovery_judge.h)
  int helped_strictly = 0;  ///< as its published evaluation counts
};

/// Counts events, which are in the order of time, in the order in which the names first come.
std::vector<RecoveryCount> CountRecoveries(const std::vector<RecoveryEvent>& events);

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_RECOVERY_RECOVERY_COUNT_H_
