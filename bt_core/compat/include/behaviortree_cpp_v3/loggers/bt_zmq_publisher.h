// The publisher of version 3. What it speaks is the protocol of Groot2, at `server_port`.
#pragma once

// The names come first.
// clang-format off
#include "behaviortree_cpp_v3/old_names.h"
#include "behaviortree_cpp/loggers/groot2_publisher.h"
// clang-format on

namespace BT {

class PublisherZMQ : public Groot2Publisher {
 public:
  explicit PublisherZMQ(const Tree& tree, unsigned = 25, unsigned = 1666,
                        unsigned server_port = 1667)
      : Groot2Publisher(tree, server_port) {}
};

}  // namespace BT
