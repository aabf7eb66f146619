// Writes a database that Groot2 reads: tables Transitions, Nodes and Definitions. A tick is in it
// when it has ended, without waiting for the disk; should the computer crash, the last ones are
// not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <unordered_map>

#include "behaviortree_cpp/loggers/abstract_logger.h"

struct sqlite3;
struct sqlite3_stmt;

namespace BT {

class SqliteLogger : public StatusChangeLogger {
 public:
  using ExtraCallback =
      std::function<std::string(Duration, const TreeNode&, NodeStatus, NodeStatus)>;

  /// The file's name ends in .db3 or .btdb. `append`: earlier sessions stay. Throws RuntimeError if
  /// it cannot be written.
  SqliteLogger(const Tree& tree, const std::filesystem::path& file, bool append = false);
  /// Everything that has happened is in the file afterwards.
  ~SqliteLogger() override;
  /// Its text becomes `extra_data` of the transition.
  void setAdditionalCallback(ExtraCallback function) { extra_ = std::move(function); }
  void callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                NodeStatus status) override;
  void execSqlStatement(std::string statement);
  void flush() override;

 protected:
  void tickEnded() override { flush(); }

 private:
  void DescribeTree(const Tree& tree);

  sqlite3* db_ = nullptr;
  sqlite3_stmt* insert_ = nullptr;
  int session_id_ = -1;
  int pending_ = 0;  // transitions of the open transaction
  int64_t last_time_ = 0;
  std::unordered_map<const TreeNode*, int64_t> started_;
  ExtraCallback extra_;
};

}  // namespace BT
