#include "editor/live/run_view.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace coppice::editor {
namespace {

constexpr double kRatePeriod = 1;  // seconds

}  // namespace

const char* ToString(RunPhase phase) {
  switch (phase) {
    case RunPhase::kConnecting:
      return "connecting";
    case RunPhase::kLive:
      return "live";
    case RunPhase::kReconnecting:
      return "reconnecting";
    case RunPhase::kLeft:
      return "no longer followed";
    case RunPhase::kLoading:
      return "loading";
    case RunPhase::kRecord:
      return "record";
    case RunPhase::kSimulation:
      return "simulation";
  }
  return "?";
}

RunView::RunView(std::unique_ptr<RunSource> source, std::shared_ptr<const NodeModels> known)
    : source_(std::move(source)), known_(std::move(known)) {}

std::string RunView::bookmark_name() const {
  if (source_->is_robot() || source_->is_simulation()) return name();
  std::error_code error;
  return std::filesystem::absolute(name(), error).lexically_normal().string();
}

RunPhase RunView::phase() const {
  if (source_->is_simulation()) return RunPhase::kSimulation;
  if (!source_->is_robot()) return source_->is_loading() ? RunPhase::kLoading : RunPhase::kRecord;
  if (is_left_) return RunPhase::kLeft;  // of robots
  if (connection_.is_live) return RunPhase::kLive;
  return was_live_ ? RunPhase::kReconnecting : RunPhase::kConnecting;
}

void RunView::Update(const HookList& hooks, double now) {
  const double passed = std::max(now - now_, 0.0);
  now_ = now;
  const std::size_t before = run_.size();
  source_->Pump(*this);
  LeaveIfTooLong();
  if (run_.size() != before) came_at_ = now;
  if (!late_answer_->empty()) answer_ = std::exchange(*late_answer_, {});
  MeasureRate(now);
  if (connection_.is_live) hooks_.Sync(hooks);
  if (was_loading_ && !source_->is_loading()) LeaveFinalHalt();
  was_loading_ = source_->is_loading();
  playhead_.Advance(passed);
  ShowTick();
  Mark(hooks);
}

// A robot may say more than there is memory for, in a second or in many days, and a record may hold
// more in some kilobytes.
void RunView::LeaveIfTooLong() {
  if (is_left_ || source_->is_simulation()) return;
  if (run_.bytes() <= most_bytes_.value_or(source_->most_bytes())) return;
  is_left_ = true;
  source_->HangUp("this run takes all the memory that one may take; connect again to go on");
  if (source_->is_robot()) return source_->Pump(*this);
  answer_ = "this record takes all the memory that one may take: its first part is shown";
}

// A record that was closed ends with the halt of the tree. What was wanted is the tick before it:
// behind the halt nothing has a status, and nothing was ticked.
void RunView::LeaveFinalHalt() {
  const auto& ticks = run_.recording().ticks();
  if (source_->is_robot() || source_->may_grow() || !playhead_.is_at_now()) return;
  std::size_t last = ticks.size();
  while (last > 0 && ticks[last - 1].result == Status::kIdle) --last;
  if (last > 0 && last < ticks.size()) playhead_.GoToTick(last - 1);
}

void RunView::MeasureRate(double now) {
  if (now - rate_from_ < kRatePeriod) return;
  rate_ = static_cast<double>(run_.size() - rate_ticks_) / (now - rate_from_);
  rate_from_ = now;
  rate_ticks_ = run_.size();
}

const HistoryFollower& RunView::follower() const {
  return shows_now_ ? run_.now() : place_.state();
}

void RunView::ShowTick() {
  if (!run_.has_tree()) return;
  const std::size_t tick = playhead_.tick();
  shows_now_ = playhead_.is_at_now() || run_.size() == 0;
  if (!shows_now_) place_.Go(tick);
  const std::size_t at = playhead_.is_at_now() ? run_.size() : tick;
  const Tracks& tracks = run_.TracksAt(at);
  std::shared_ptr<const RunTree>& tree = trees_[tracks.tree().get()];
  if (!tree) tree = std::make_shared<RunTree>(tracks.tree(), *known_);
  tree_ = tree;

  // Live, time goes on between ticks: the robot may tick only when there is something to do.
  const bool flows = playhead_.is_at_now() && phase() == RunPhase::kLive &&
                     stop_.where == DebugStop::Where::kNowhere;
  state_.now = playhead_.time();
  if (flows) state_.now += Duration(static_cast<Duration::rep>((now_ - came_at_) * 1e9));
  state_.is_fresh = phase() != RunPhase::kReconnecting && phase() != RunPhase::kConnecting;
  const HistoryFollower& shown = follower();
  state_.states.assign(tracks.shape().size(), NodeState());
  for (NodeIndex i{0}; i < state_.states.size(); ++i) {
    NodeState& node = state_.states[i];
    node.status = shown.status(i);
    node.before = shown.last(i);
    if (node.status == Status::kIdle || run_.size() == 0) continue;
    const std::size_t since = std::min(tracks.LaneOf(i).Since(tick), run_.size() - 1);
    node.since = std::max(run_.TimeOf(since), Time(Duration(1)));  // 0: not known
  }
}

void RunView::Mark(const HookList& hooks) {
  if (!tree_) return;
  const auto& nodes = tree_->description()->nodes;
  // The notice may say the path alone.
  for (NodeIndex i{0}; stop_.node == kNoNode && i < nodes.size(); ++i) {
    if (!stop_path_.empty() && nodes[i].path == stop_path_) stop_.node = i;
  }
  const auto mark = [&](const std::string& path, std::uint8_t marks) {
    for (std::size_t i = 0; i < nodes.size() && i < state_.states.size(); ++i) {
      if (nodes[i].path == path) state_.states[i].marks |= marks;
    }
  };
  for (const WantedHook& wanted : hooks.all()) {
    if (!wanted.robot.empty() && wanted.robot != name()) continue;
    const bool enabled = wanted.hook.enabled;
    if (!IsBreakpoint(wanted.hook) && !enabled) continue;
    mark(wanted.hook.path, !IsBreakpoint(wanted.hook) ? kFaultMark
                           : enabled                  ? kBreakpointMark
                                                      : kBreakpointOffMark);
  }
  const bool stands =
      stop_.where == DebugStop::Where::kBefore || stop_.where == DebugStop::Where::kAfter;
  if (stands && playhead_.is_at_now() && stop_.node < state_.states.size()) {
    state_.states[stop_.node].marks |= kStopMark;
  }
}

void RunView::OnConnection(const LiveConnection& connection) {
  if (connection_.is_live && !connection.is_live) pictures_.Clear();
  connection_ = connection;
  was_live_ = was_live_ || connection.is_live;
  if (connection.is_live) return;
  hooks_.Forget();
  foreign_hooks_.clear();
  stop_ = DebugStop();
}

void RunView::OnNotice(const LiveNotice& notice) {
  hooks_.OnNotice(notice);
  switch (notice.event.kind) {
    case DebugEvent::Kind::kStopped:
      stop_ = notice.event.stop;
      stop_path_ = notice.path;
      playhead_.GoToNow();
      break;
    case DebugEvent::Kind::kResumed:
      stop_ = DebugStop();
      stop_path_.clear();
      break;
    case DebugEvent::Kind::kReplaced:
      break;
    case DebugEvent::Kind::kRefused:
      answer_ = "not stopped: " + notice.event.reason;
      break;
  }
}

void RunView::Send(LiveCommand command, std::function<void()> on_refusal) {
  source_->Send(std::move(command), [answer = late_answer_,
                                     on_refusal = std::move(on_refusal)](const LiveReply& reply) {
    if (reply) return;
    *answer = reply.problem();
    if (on_refusal) on_refusal();
  });
}

}  // namespace coppice::editor
