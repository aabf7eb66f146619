#include <cstdio>
#include <iostream>
#include <utility>

#include "behaviortree_cpp/loggers/abstract_logger.h"
#include "behaviortree_cpp/loggers/bt_cout_logger.h"
#include "behaviortree_cpp/loggers/bt_minitrace_logger.h"
#include "behaviortree_cpp/loggers/bt_observer.h"

namespace BT {

StatusChangeLogger::StatusChangeLogger(TreeNode* root_node) { subscribeToTreeChanges(root_node); }

StatusChangeLogger::~StatusChangeLogger() = default;

void StatusChangeLogger::subscribeToTreeChanges(TreeNode* root_node) {
  start_ = std::chrono::high_resolution_clock::now();
  applyRecursiveVisitor(root_node, [this](TreeNode* node) {
    subscribers_.push_back(node->subscribeToStatusChange(
        [this](TimePoint time, const TreeNode& changed, NodeStatus before, NodeStatus status) {
          Pass(time, changed, before, status);
        }));
  });
  tick_end_ = root_node->SubscribeToTickEnd([this] { tickEnded(); });
}

void StatusChangeLogger::Pass(TimePoint time, const TreeNode& node, NodeStatus before,
                              NodeStatus status) {
  if (!enabled_ || (status == NodeStatus::IDLE && !shows_idle_)) return;
  const TimePoint origin = type_ == TimestampType::absolute ? TimePoint() : start_;
  callback(time - origin, node, before, status);
}

void StdCoutLogger::callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                             NodeStatus status) {
  const double seconds = std::chrono::duration<double>(timestamp).count();
  std::printf("[%.3f]: %-25s %s -> %s", seconds, node.name().c_str(),
              toStr(prev_status, true).c_str(), toStr(status, true).c_str());
  std::cout << std::endl;
}

void StdCoutLogger::flush() { std::cout << std::flush; }

// ---- Counts.

TreeObserver::TreeObserver(const Tree& tree) : StatusChangeLogger(tree.rootNode()) {
  for (const auto& subtree : tree.subtrees) {
    for (const auto& node : subtree->nodes) {
      statistics_[node->UID()] = {};
      path_to_uid_[node->fullPath()] = node->UID();
      uid_to_path_[node->UID()] = node->fullPath();
    }
  }
}

void TreeObserver::resetStatistics() {
  for (auto& [uid, statistics] : statistics_) statistics = {};
}

const TreeObserver::NodeStatistics& TreeObserver::getStatistics(const std::string& path) const {
  return getStatistics(path_to_uid_.at(path));
}

const TreeObserver::NodeStatistics& TreeObserver::getStatistics(uint16_t uid) const {
  const auto found = statistics_.find(uid);
  if (found == statistics_.end()) throw LogicError("Wrong UID");
  return found->second;
}

void TreeObserver::callback(Duration timestamp, const TreeNode& node, NodeStatus,
                            NodeStatus status) {
  NodeStatistics& statistics = statistics_[node.UID()];
  statistics.current_status = status;
  statistics.last_timestamp = timestamp;
  if (status == NodeStatus::IDLE) return;
  ++statistics.transitions_count;
  if (isStatusCompleted(status)) statistics.last_result = status;
  statistics.success_count += status == NodeStatus::SUCCESS;
  statistics.failure_count += status == NodeStatus::FAILURE;
  statistics.skip_count += status == NodeStatus::SKIPPED;
}

// ---- Trace.

MinitraceLogger::MinitraceLogger(const Tree& tree, const char* filename_json)
    : file_(std::fopen(filename_json, "w"), &std::fclose) {
  if (!file_) throw RuntimeError(filename_json, ": cannot be written");
  std::fputs("{\"traceEvents\":[", file_.get());
  subscribeToTreeChanges(tree.rootNode());
}

MinitraceLogger::~MinitraceLogger() {
  unsubscribeFromTreeChanges();
  std::fputs("\n]}\n", file_.get());
}

void MinitraceLogger::callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                               NodeStatus status) {
  const char* phase = nullptr;
  if (prev_status == NodeStatus::IDLE && isStatusCompleted(status)) phase = "I";
  if (status == NodeStatus::RUNNING) phase = "B";
  if (prev_status == NodeStatus::RUNNING && status != NodeStatus::RUNNING) phase = "E";
  if (!phase) return;
  const auto time = std::chrono::duration_cast<std::chrono::microseconds>(timestamp).count();
  const nlohmann::json event = {{"cat", toStr(node.type())},
                                {"name", node.name()},
                                {"ph", phase},
                                {"pid", 1},
                                {"tid", 1},
                                {"ts", time}};
  std::fprintf(file_.get(), "%s\n%s", is_first_ ? "" : ",", event.dump().c_str());
  is_first_ = false;
}

void MinitraceLogger::flush() { std::fflush(file_.get()); }

}  // namespace BT
