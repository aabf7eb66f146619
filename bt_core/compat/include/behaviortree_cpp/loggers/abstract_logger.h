// The base of all who write down what becomes of the nodes of a tree.
#ifndef ABSTRACT_LOGGER_H
#define ABSTRACT_LOGGER_H

#include <memory>
#include <vector>

#include "behaviortree_cpp/behavior_tree.h"
#include "behaviortree_cpp/bt_factory.h"

namespace BT {

enum class TimestampType {
  absolute,  ///< since 1970
  relative   ///< since the logger was made
};

/// Must not outlive the tree. A class calls unsubscribeFromTreeChanges() first in its destructor.
class StatusChangeLogger {
 public:
  explicit StatusChangeLogger(TreeNode* root_node);
  virtual ~StatusChangeLogger();
  StatusChangeLogger(const StatusChangeLogger&) = delete;
  StatusChangeLogger& operator=(const StatusChangeLogger&) = delete;

  /// Called on the ticking thread at every change. What a node does at once is a change to its
  /// result; SKIPPED is none.
  virtual void callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                        NodeStatus status) = 0;
  virtual void flush() = 0;

  void setEnabled(bool enabled) { enabled_ = enabled; }
  bool enabled() const { return enabled_; }
  void setTimestampType(TimestampType type) { type_ = type; }
  /// Whether changes to IDLE are told; they are.
  void enableTransitionToIdle(bool enable) { shows_idle_ = enable; }
  bool showsTransitionToIdle() const { return shows_idle_; }

 protected:
  StatusChangeLogger() = default;
  void subscribeToTreeChanges(TreeNode* root_node);
  void unsubscribeFromTreeChanges() {
    subscribers_.clear();
    tick_end_.reset();
  }
  /// After each tick and each halt of the tree: what is written to a file should be there now,
  /// should the program be killed. Ticking thread.
  virtual void tickEnded() {}

 private:
  void Pass(TimePoint time, const TreeNode& node, NodeStatus before, NodeStatus status);

  bool enabled_ = true;
  bool shows_idle_ = true;
  TimestampType type_ = TimestampType::absolute;
  TimePoint start_{};
  std::vector<TreeNode::StatusChangeSubscriber> subscribers_;
  Signal<>::Subscriber tick_end_;
};

}  // namespace BT

#endif  // ABSTRACT_LOGGER_H
