// What the sources of runs in tests have in common: the test tells what comes from the run, and
// sees what is sent to it.
#ifndef COPPICE_TESTS_EDITOR_TOLD_SOURCE_H_
#define COPPICE_TESTS_EDITOR_TOLD_SOURCE_H_

#include <string>
#include <utility>
#include <vector>

#include "editor/live/live_queue.h"
#include "editor/live/run_source.h"

namespace coppice::editor {

class ToldSource : public RunSource {
 public:
  const std::string& name() const override { return name_; }
  bool is_robot() const override { return is_robot_; }
  void Pump(LiveListener& listener) override { queue_.Deliver(listener); }
  bool has_news() const override { return !queue_.empty(); }
  /// Every command succeeds.
  void Send(LiveCommand command, LiveClient::ReplyHandler on_reply) override {
    commands.push_back(command);
    HookAnswer answer;
    if (command.kind == LiveCommand::Kind::kAddHook) answer.id = ++last_hook_;
    queue_.PutReply(std::move(on_reply), answer);
  }

  void Connect() { TellConnection(is_robot_, ""); }
  void Disconnect(const std::string& why) { TellConnection(false, why); }

  void Show(const LivePicture& picture) { queue_.OnPicture(picture); }
  void TellForeignHooks(const std::vector<ForeignHook>& hooks) { queue_.OnForeignHooks(hooks); }

  std::vector<LiveCommand> commands;  ///< that it was sent

 protected:
  ToldSource(std::string name, bool is_robot) : name_(std::move(name)), is_robot_(is_robot) {
    Connect();
  }

  /// The run stands before that node, at the hook that was set last.
  void TellStop(NodeIndex node, const std::string& path, std::uint64_t tick) {
    LiveNotice notice;
    notice.event.kind = DebugEvent::Kind::kStopped;
    notice.event.stop = {DebugStop::Where::kBefore, node, Status::kIdle, last_hook_, tick};
    notice.path = path;
    queue_.OnNotice(notice);
  }

  LiveQueue queue_{nullptr};

 private:
  void TellConnection(bool is_live, const std::string& problem) {
    LiveConnection connection;
    connection.protocol = LiveConnection::Protocol::kCoppice;
    connection.is_live = is_live;
    connection.problem = problem;
    queue_.OnConnection(connection);
  }

  const std::string name_;
  const bool is_robot_;
  HookId last_hook_ = kNoHook;
};

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_TOLD_SOURCE_H_
