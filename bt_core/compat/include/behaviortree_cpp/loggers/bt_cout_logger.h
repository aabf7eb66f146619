// Prints every change of a status, for people.
#ifndef BT_COUT_LOGGER_H
#define BT_COUT_LOGGER_H

#include "behaviortree_cpp/loggers/abstract_logger.h"

namespace BT {

/// "[1700000000.123]: NAME   IDLE -> RUNNING" on standard output, with colours.
class StdCoutLogger : public StatusChangeLogger {
 public:
  explicit StdCoutLogger(const Tree& tree) : StatusChangeLogger(tree.rootNode()) {}
  ~StdCoutLogger() override { unsubscribeFromTreeChanges(); }
  void flush() override;

 private:
  void callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                NodeStatus status) override;
};

}  // namespace BT

#endif  // BT_COUT_LOGGER_H
