// What the functions of this interface throw. Errors of a tree carry file:line:column and a hint,
// as everywhere in Coppice.
#ifndef BT_EXCEPTIONS_H
#define BT_EXCEPTIONS_H

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "behaviortree_cpp/utils/strcat.hpp"

namespace BT {

class BehaviorTreeException : public std::exception {
 public:
  BehaviorTreeException(std::string_view message) : message_(message) {}
  /// The texts are joined.
  template <class... Texts>
  BehaviorTreeException(const Texts&... texts) : message_(StrCat(texts...)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

/// The program uses the library wrongly: it can be known before anything runs.
class LogicError : public BehaviorTreeException {
 public:
  using BehaviorTreeException::BehaviorTreeException;
};

/// It can be known only while the program runs: files, trees, values.
class RuntimeError : public BehaviorTreeException {
 public:
  using BehaviorTreeException::BehaviorTreeException;
};

struct TickBacktraceEntry {
  std::string node_name;
  std::string node_path;
  std::string registration_name;
};

/// A node threw in a tick: which one, and what it said.
class NodeExecutionError : public RuntimeError {
 public:
  NodeExecutionError(TickBacktraceEntry failed_node, const std::string& original_message)
      : RuntimeError("Exception in node '", failed_node.node_path, "' [",
                     failed_node.registration_name, "]: ", original_message),
        failed_node_(std::move(failed_node)),
        original_message_(original_message) {}
  const TickBacktraceEntry& failedNode() const { return failed_node_; }
  const std::string& originalMessage() const { return original_message_; }

 private:
  TickBacktraceEntry failed_node_;
  std::string original_message_;
};

}  // namespace BT

#endif  // BT_EXCEPTIONS_H
