// Writes a .btlog, which Groot2, the editor and `coppice` read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "behaviortree_cpp/loggers/abstract_logger.h"

namespace BT {

class FileLogger2 : public StatusChangeLogger {
 public:
  struct Transition {
    uint64_t timestamp_usec;
    uint16_t node_uid;
    uint8_t status;
  };

  /// Throws RuntimeError if the name does not end in ".btlog" or the file cannot be written.
  FileLogger2(const Tree& tree, const std::filesystem::path& filepath);
  /// Everything that has happened is in the file afterwards.
  ~FileLogger2() override;
  void callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                NodeStatus status) override;
  void flush() override;

 protected:
  void tickEnded() override { flush(); }
  struct AnyName {};
  FileLogger2(const Tree& tree, const std::filesystem::path& filepath, AnyName);

 private:
  struct Pimpl;
  std::unique_ptr<Pimpl> _p;
};

}  // namespace BT
