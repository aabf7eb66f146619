// A run of a real tree in the process of the test, as a source of the editor: the test ticks it
// between frames. Every tick takes a millisecond, so that pictures are always the same.
#ifndef COPPICE_TESTS_EDITOR_EXECUTED_SOURCE_H_
#define COPPICE_TESTS_EDITOR_EXECUTED_SOURCE_H_

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "editor/live/mailbox.h"
#include "editor/live/run_source.h"
#include "tests/editor/driver.h"
#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {

class ExecutedSource final : public RunSource {
 public:
  ExecutedSource(std::string name, const std::string& trees, bool is_robot = true)
      : tree(trees), name_(std::move(name)), is_robot_(is_robot) {
    connection_.is_live = is_robot;
    connection_.protocol = LiveConnection::Protocol::kCoppice;
    mailbox_.OnConnection(connection_);
    follow_ = std::make_unique<coppice::editor::Follow>(tree.executor, even_);
  }

  const std::string& name() const override { return name_; }
  bool is_robot() const override { return is_robot_; }
  void Pump(LiveListener& listener) override { mailbox_.Deliver(listener); }
  bool has_news() const override { return !mailbox_.empty(); }
  void Send(LiveCommand command, LiveClient::ReplyHandler on_reply) override {
    commands.push_back(command);
    LiveReply reply;
    if (command.kind == LiveCommand::Kind::kAddHook) reply.hook = ++last_hook_;
    mailbox_.PutReply(std::move(on_reply), reply);
  }

  void Ticks(int count) {
    for (int i = 0; i < count; ++i) tree.Tick();
  }
  void Disconnect(const std::string& why) {
    connection_.is_live = false;
    connection_.problem = why;
    mailbox_.OnConnection(connection_);
  }
  /// So many ticks do not come through.
  void Lose(std::uint64_t ticks) {
    HistoryGap gap;
    gap.lost_ticks = ticks;
    even_.OnGap(gap);
    follow_->Begin(HistoryState::Cause::kLost);
  }
  void Tell(const LiveNotice& notice) { mailbox_.OnNotice(notice); }
  void StopBefore(NodeIndex node) {
    LiveNotice notice;
    notice.event.kind = DebugEvent::Kind::kStopped;
    notice.event.stop = {DebugStop::Where::kBefore, node, Status::kIdle, last_hook_, 1};
    notice.path = tree.executor.shared_program()->Path(node);
    Tell(notice);
  }

  ExecutedTree tree;
  std::vector<LiveCommand> commands;  ///< that it was sent

 private:
  class Even final : public HistoryHandler {
   public:
    explicit Even(HistoryHandler& handler) : handler_(handler) {}
    void OnTree(const TreeDescription& tree) override { handler_.OnTree(tree); }
    void OnState(const HistoryState& state) override { handler_.OnState(state); }
    void OnTick(const TickEvents& events) override {
      TickEvents even = events;
      even.duration = std::chrono::milliseconds(1);
      handler_.OnTick(even);
    }

    void OnGap(const HistoryGap& gap) override { handler_.OnGap(gap); }

   private:
    HistoryHandler& handler_;
  };

  const std::string name_;
  const bool is_robot_;
  Mailbox mailbox_{nullptr};
  LiveConnection connection_;
  Even even_{mailbox_};
  std::unique_ptr<coppice::editor::Follow> follow_;
  HookId last_hook_ = kNoHook;
};

/// A door that must be open before the robot passes.
inline constexpr char kDoorTrees[] = R"(<BehaviorTree ID="Main"><Sequence name="mission">
  <Fallback name="door"><Is as="open" name="IsDoorOpen"/>
    <Do as="open it" name="OpenDoor" count="{attempts}"/></Fallback>
  <SubTree ID="Pass" name="pass"/></Sequence></BehaviorTree>
  <BehaviorTree ID="Pass"><Do as="drive" name="Drive" count="{steps}"/></BehaviorTree>)";

/// Adds it to the editor, which owns it, and ticks it.
inline ExecutedSource* AddExecuted(Driver& driver, const std::string& name, int ticks,
                                   bool is_robot = true) {
  auto source = std::make_unique<ExecutedSource>(name, kDoorTrees, is_robot);
  ExecutedSource* added = source.get();
  added->tree.results["drive"] = Status::kRunning;
  added->Ticks(ticks);
  driver.editor.AddRun(std::move(source));
  driver.Frames();
  return added;
}

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_EXECUTED_SOURCE_H_
