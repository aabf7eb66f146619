#include "bt_core/live/live_publisher.h"

#include <pthread.h>

#include <exception>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>
#include <variant>

#include "bt_core/live/board_copier.h"
#include "bt_core/live/board_message.h"
#include "bt_core/live/full_tree.h"
#include "bt_core/live/groot2_protocol.h"
#include "bt_core/live/socket_pair.h"
#include "bt_core/live/status_board.h"

namespace coppice {

// Everything that the serving thread needs. It never touches the executor but through its inbox.
class LivePublisher::Server {
 public:
  Server(Executor& executor, const LiveOptions& options)
      : sockets_(options.address, options.port),
        program_(executor.shared_program()),
        nodes_(NodesByInstance(*program_)),
        statuses_(executor.statuses()),
        copier_(executor),
        patience_(options.patience),
        thread_([this] { Serve(); }) {}

  ~Server() {
    copier_.Cancel();
    sockets_.Shutdown();
    thread_.join();
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const { return sockets_.port(); }
  void Apply(const std::vector<StatusChange>& changes) { statuses_.Apply(changes); }

 private:
  void Serve() {
    pthread_setname_np(pthread_self(), "coppice_live");
    groot2::Parts request;
    while (sockets_.Receive(request)) sockets_.Reply(Answer(request));
  }

  groot2::Parts Answer(const groot2::Parts& parts) {
    const auto parsed = groot2::ParseRequest(parts);
    if (const std::string* problem = std::get_if<std::string>(&parsed)) {
      return groot2::MakeError(*problem);
    }
    const auto& request = std::get<groot2::Request>(parsed);
    try {
      return groot2::MakeReply(request, tree_id_, Payload(request));
    } catch (const std::exception& error) {  // for example text that is not UTF-8
      return groot2::MakeError(error.what());
    }
  }

  std::string Payload(const groot2::Request& request) {
    switch (request.type) {
      case groot2::RequestType::kFullTree:
        return WriteFullTree(*program_);
      case groot2::RequestType::kStatus:
        return Statuses();
      default:
        return Boards(request.argument);
    }
  }

  std::string Statuses() {
    statuses_.Read(bytes_);
    std::string payload;
    payload.reserve(nodes_.size() * 3);
    for (const NodeIndex node : nodes_) groot2::AppendStatus(payload, Uid(node), bytes_[node]);
    return payload;
  }

  std::string Boards(std::string_view names) {
    const Layout& layout = program_->layout;
    const std::vector<ScopeIndex> scopes = FindScopes(layout, groot2::SplitNames(names));
    if (scopes.empty()) return WriteBoards(layout, scopes, {});
    return WriteBoards(layout, scopes, copier_.Copy(scopes, patience_));
  }

  SocketPair sockets_;
  const std::shared_ptr<const Program> program_;
  const std::vector<NodeIndex> nodes_;
  const groot2::TreeId tree_id_ = groot2::RandomTreeId();
  StatusBoard statuses_;
  BoardCopier copier_;
  const Duration patience_;
  std::vector<std::uint8_t> bytes_;
  std::thread thread_;  // last: starts when the rest is there
};

LivePublisher::LivePublisher(Executor& executor, const LiveOptions& options) : executor_(executor) {
  const std::size_t nodes = executor.program().nodes.size();
  if (nodes > groot2::kMaxNodes) {
    throw std::runtime_error("live view: the tree has " + std::to_string(nodes) +
                             " nodes; the protocol can number " +
                             std::to_string(groot2::kMaxNodes));
  }
  server_ = std::make_unique<Server>(executor, options);
  executor_.AddSink(this);
}

LivePublisher::~LivePublisher() { executor_.RemoveSink(this); }

std::uint16_t LivePublisher::port() const { return server_->port(); }

void LivePublisher::OnTick(const TickEvents& events) { server_->Apply(events.changes); }

}  // namespace coppice
