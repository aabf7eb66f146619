// Writes a trace that chrome://tracing and Perfetto read.
#pragma once

#include <cstdio>
#include <memory>

#include "behaviortree_cpp/loggers/abstract_logger.h"

namespace BT {

class MinitraceLogger : public StatusChangeLogger {
 public:
  /// Throws RuntimeError if the file cannot be written.
  MinitraceLogger(const Tree& tree, const char* filename_json);
  /// The file is whole afterwards.
  ~MinitraceLogger() override;
  void callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                NodeStatus status) override;
  void flush() override;

 protected:
  void tickEnded() override { flush(); }

 private:
  std::unique_ptr<FILE, int (*)(FILE*)> file_;
  bool is_first_ = true;
};

}  // namespace BT
