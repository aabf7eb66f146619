// Counts what the nodes of a tree do.
#ifndef BT_OBSERVER_H
#define BT_OBSERVER_H

#include <cassert>
#include <map>
#include <string>
#include <unordered_map>

#include "behaviortree_cpp/loggers/abstract_logger.h"

namespace BT {

class TreeObserver : public StatusChangeLogger {
 public:
  struct NodeStatistics {
    NodeStatus last_result = NodeStatus::IDLE;  ///< SUCCESS or FAILURE
    NodeStatus current_status = NodeStatus::IDLE;
    unsigned transitions_count = 0;  ///< not to IDLE
    unsigned success_count = 0;
    unsigned failure_count = 0;
    unsigned skip_count = 0;
    Duration last_timestamp = {};
  };

  explicit TreeObserver(const Tree& tree);
  ~TreeObserver() override { unsubscribeFromTreeChanges(); }
  void flush() override {}
  void resetStatistics();

  /// Throws std::out_of_range, respectively LogicError, if there is no such node.
  const NodeStatistics& getStatistics(const std::string& path) const;
  const NodeStatistics& getStatistics(uint16_t uid) const;
  const std::unordered_map<uint16_t, NodeStatistics>& statistics() const { return statistics_; }
  const std::unordered_map<std::string, uint16_t>& pathToUID() const { return path_to_uid_; }
  const std::map<uint16_t, std::string>& uidToPath() const { return uid_to_path_; }

 private:
  void callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                NodeStatus status) override;

  std::unordered_map<uint16_t, NodeStatistics> statistics_;
  std::unordered_map<std::string, uint16_t> path_to_uid_;
  std::map<uint16_t, std::string> uid_to_path_;
};

}  // namespace BT

#endif  // BT_OBSERVER_H
