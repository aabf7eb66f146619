// Lets Groot2, the editor and `coppice live` watch a running tree, and stop it at nodes.
#pragma once

#include <chrono>
#include <memory>

#include "behaviortree_cpp/loggers/abstract_logger.h"

namespace coppice {
class Executor;
}

namespace BT {

/// Listens on this computer only (127.0.0.1), at the port and the next one. Must not outlive the
/// tree; one at a time for a tree.
class Groot2Publisher {
 public:
  /// Throws RuntimeError if the ports cannot be had.
  explicit Groot2Publisher(const Tree& tree, unsigned server_port = 1667);
  ~Groot2Publisher();
  Groot2Publisher(const Groot2Publisher&) = delete;
  Groot2Publisher& operator=(const Groot2Publisher&) = delete;

  /// After so long without a sign of life, what a client holds is released. Those that are
  /// connected connect again.
  void setMaxHeartbeatDelay(std::chrono::milliseconds delay);
  std::chrono::milliseconds maxHeartbeatDelay() const { return delay_; }

 private:
  struct PImpl;
  void Open();

  coppice::Executor& executor_;
  std::uint16_t port_;
  std::chrono::milliseconds delay_{5000};
  std::unique_ptr<PImpl> _p;
};

}  // namespace BT
