// The log of version 3. What is written is a .btlog, the log of version 4.
#pragma once

// The names come first.
// clang-format off
#include "behaviortree_cpp_v3/old_names.h"
#include "behaviortree_cpp/loggers/bt_file_logger_v2.h"
// clang-format on

namespace BT {

class FileLogger : public FileLogger2 {
 public:
  FileLogger(const Tree& tree, const char* filename, uint16_t = 10)
      : FileLogger2(tree, filename, AnyName()) {}
};

}  // namespace BT
