#include "editor/live/robot_source.h"

#include <utility>

namespace coppice::editor {

namespace {

constexpr std::size_t kMostWaitingBytes = 32 << 20;  // between two frames of the editor

// "host:port/TREE" names one tree of several.
LiveClientOptions WithTree(const std::string& endpoint, LiveClientOptions options) {
  const std::size_t slash = endpoint.find('/');
  if (slash != std::string::npos) options.tree = endpoint.substr(slash + 1);
  return options;
}

}  // namespace

RobotSource::RobotSource(std::string endpoint, std::function<void()> wake,
                         const LiveClientOptions& options)
    : endpoint_(std::move(endpoint)), queue_(std::move(wake), kMostWaitingBytes) {
  client_.emplace(endpoint_.substr(0, endpoint_.find('/')), queue_, WithTree(endpoint_, options));
}

LiveClientOptions RobotSource::DefaultOptions() {
  LiveClientOptions options;
  options.name = "coppice-edit";
  options.token = TokenFromEnvironment();
  options.with_pictures = true;
  return options;
}

void RobotSource::HangUp(const std::string& why) {
  queue_.StopWaiting();
  client_.reset();
  why_ = why;
  LiveConnection connection;
  connection.problem = why;
  queue_.OnConnection(connection);
}

void RobotSource::Send(LiveCommand command, LiveClient::ReplyHandler on_reply) {
  if (!client_) return queue_.PutReply(std::move(on_reply), Problem{why_});
  client_->Send(std::move(command), [this, on_reply = std::move(on_reply)](const LiveReply& reply) {
    queue_.PutReply(on_reply, reply);
  });
}

}  // namespace coppice::editor
