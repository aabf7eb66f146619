// One run that is open: where it comes from, all that has come of it, and the moment of it that the
// user looks at. Live and replay are the same; live the playhead is glued to the end.
//
//   RunView view(std::make_unique<RobotSource>("robot:1667"), models);
//   view.Update(hooks, now);                 // once per frame
//   view.playhead().GoToTick(4711);
//   view.state().states[7].status;           // at the tick that is shown
#ifndef COPPICE_EDITOR_LIVE_RUN_VIEW_H_
#define COPPICE_EDITOR_LIVE_RUN_VIEW_H_

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/live/run_hooks.h"
#include "editor/live/run_source.h"
#include "editor/live/run_tree.h"
#include "editor/live/tree_snapshot.h"
#include "editor/timeline/playhead.h"

namespace coppice::editor {

enum class RunPhase : std::uint8_t {
  kConnecting,
  kLive,
  kReconnecting,
  kLeft,  ///< it had become too long: RunView::set_most_bytes
  kLoading,
  kRecord,
  kSimulation
};

/// "connecting", "live", "reconnecting", "no longer followed", "loading", "record", "simulation".
const char* ToString(RunPhase phase);

class RunView final : private LiveListener {
 public:
  RunView(std::unique_ptr<RunSource> source, std::shared_ptr<const NodeModels> known);

  /// In the place of what its source says.
  void set_most_bytes(std::size_t bytes) { most_bytes_ = bytes; }

  /// Takes in what has come, and moves the playhead; `now` in seconds of the editor.
  void Update(const HookList& hooks, double now);

  RunSource& source() { return *source_; }
  const RunSource& source() const { return *source_; }
  const std::string& name() const { return source_->name(); }
  /// By which its bookmarks are known: of a file the whole path.
  std::string bookmark_name() const;
  RunPhase phase() const;
  const LiveConnection& connection() const { return connection_; }
  /// Ticks per second of the editor, of late.
  double rate() const { return rate_; }

  const Run& run() const { return run_; }
  Playhead& playhead() { return playhead_; }
  const Playhead& playhead() const { return playhead_; }
  /// The tree at the shown tick; null before there is one.
  const std::shared_ptr<const RunTree>& tree() const { return tree_; }
  /// Before the first tick is shown: of the run, or of one that was begun anew.
  bool is_at_beginning() const {
    return playhead_.is_at_now() && (run_.size() == 0 || run_.is_at_beginning());
  }
  /// How it stands there, as of the last Update. There must be a tree.
  const HistoryFollower& follower() const;
  const TreeSnapshot& state() const { return state_; }

  /// Where the robot stands; kNowhere: it runs.
  const DebugStop& stop() const { return stop_; }
  const std::string& stop_path() const { return stop_path_; }
  const RunHooks& hooks() const { return hooks_; }
  /// Those that others have left in the robot.
  const std::vector<ForeignHook>& foreign_hooks() const { return foreign_hooks_; }

  /// What the robot shows to people now, whichever tick is shown; nothing while it does not answer.
  const PictureSet& pictures() const { return pictures_; }

  /// Why the last command was refused, or what came of it; empty after it was read.
  std::string TakeAnswer() { return std::exchange(answer_, {}); }
  /// Tells the robot; what is wrong becomes the answer, and `on_refusal` is called.
  void Send(LiveCommand command, std::function<void()> on_refusal = {});

 private:
  void OnConnection(const LiveConnection& connection) override;
  void OnNotice(const LiveNotice& notice) override;
  void OnForeignHooks(const std::vector<ForeignHook>& hooks) override { foreign_hooks_ = hooks; }
  void OnPicture(const LivePicture& picture) override {
    static_cast<void>(pictures_.Put(picture));  // within the limits, or not shown
  }
  void OnTree(const TreeDescription& tree) override { run_.OnTree(tree); }
  void OnState(const HistoryState& state) override { run_.OnState(state); }
  void OnTick(const TickEvents& events) override { run_.OnTick(events); }
  void OnGap(const HistoryGap& gap) override { run_.OnGap(gap); }
  void OnNote(const HistoryNote& note) override { run_.OnNote(note); }
  void OnEnd(const HistoryEnd& end) override { run_.OnEnd(end); }

  void MeasureRate(double now);
  void LeaveIfTooLong();
  void LeaveFinalHalt();
  void ShowTick();
  void Mark(const HookList& hooks);

  std::unique_ptr<RunSource> source_;
  std::shared_ptr<const NodeModels> known_;
  RunHooks hooks_{*source_};
  std::vector<ForeignHook> foreign_hooks_;
  PictureSet pictures_;
  LiveConnection connection_;
  bool was_live_ = false;
  bool is_left_ = false;
  std::optional<std::size_t> most_bytes_;
  bool was_loading_ = true;
  Run run_;
  RunPlace place_{run_};
  Playhead playhead_{run_};
  std::shared_ptr<const RunTree> tree_;
  std::map<const TreeDescription*, std::shared_ptr<const RunTree>> trees_;
  bool shows_now_ = true;  // not what place_ says
  TreeSnapshot state_;
  DebugStop stop_;
  std::string stop_path_;
  std::string answer_;
  std::shared_ptr<std::string> late_answer_ = std::make_shared<std::string>();
  double now_ = 0;
  double came_at_ = 0;  // the last tick
  double rate_ = 0;
  double rate_from_ = 0;
  std::size_t rate_ticks_ = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_VIEW_H_
