#include "behaviortree_cpp/loggers/groot2_publisher.h"

#include "bt_core/compat/tree_run.h"
#include "bt_core/live/server/live_publisher.h"

namespace BT {

struct Groot2Publisher::PImpl {
  PImpl(coppice::Executor& executor, const coppice::LiveOptions& options)
      : stream(executor), publisher(stream, options) {}
  coppice::EventStream stream;
  coppice::LivePublisher publisher;
};

Groot2Publisher::Groot2Publisher(const Tree& tree, unsigned server_port) {
  coppice::LiveOptions options;
  options.port = static_cast<std::uint16_t>(server_port);
  try {
    _p = std::make_unique<PImpl>(tree.run().executor(), options);
  } catch (const std::exception& error) {
    throw RuntimeError(error.what());
  }
}

Groot2Publisher::~Groot2Publisher() = default;

}  // namespace BT
