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

Groot2Publisher::Groot2Publisher(const Tree& tree, unsigned server_port)
    : executor_(tree.run().executor()), port_(static_cast<std::uint16_t>(server_port)) {
  if (server_port > UINT16_MAX) {
    throw RuntimeError("Groot2Publisher: there is no port " + std::to_string(server_port));
  }
  Open();
}

void Groot2Publisher::setMaxHeartbeatDelay(std::chrono::milliseconds delay) {
  delay_ = delay;
  Open();
}

void Groot2Publisher::Open() {
  _p.reset();  // the ports are wanted again
  coppice::LiveOptions options;
  options.port = port_;
  options.deadline = delay_;
  try {
    _p = std::make_unique<PImpl>(executor_, options);
  } catch (const std::exception& error) {
    throw RuntimeError(error.what());
  }
}

Groot2Publisher::~Groot2Publisher() = default;

}  // namespace BT
