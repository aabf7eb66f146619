#include "editor/live/run_need.h"

namespace coppice::editor {
namespace {

using Level = RunNeed::Level;

std::string WithProblem(const std::string& what, const RunView& run) {
  const std::string& problem = run.connection().problem;
  return problem.empty() ? what : what + ": " + problem;
}

// What it asks of people in its newest tick; empty if nothing.
std::string AskedNow(const RunView& run) {
  if (run.run().size() == 0 || !run.tree()) return {};
  const std::size_t tick = run.run().size() - 1;
  const Tracks& tracks = run.run().TracksAt(tick);
  if (tracks.tree() != run.tree()->description()) return {};  // an older tree is shown
  for (const AskingNode& asking : run.tree()->asking()) {
    const Status status = tracks.LaneOf(asking.node).At(tick);
    if (status == Status::kRunning || status == Status::kFailure) return asking.words;
  }
  return {};
}

// Nothing comes after it.
bool HasFailed(const RunView& run) {
  const auto& ticks = run.run().recording().ticks();
  return !ticks.empty() && ticks.back().result == Status::kFailure && run.rate() == 0;
}

RunNeed NeedOfLive(const RunView& run) {
  const std::string asked = AskedNow(run);
  if (!asked.empty()) return {Level::kCome, "asks: " + asked};
  const std::string stop = StopText(run);
  if (!stop.empty()) return {Level::kLook, stop};
  if (HasFailed(run)) return {Level::kLook, "its tree has ended with FAILURE"};
  return {};
}

}  // namespace

RunNeed NeedOf(const RunView& run) {
  if (run.phase() == RunPhase::kLive) return NeedOfLive(run);
  if (run.phase() == RunPhase::kReconnecting) {
    return {Level::kCome, WithProblem("does not answer", run)};
  }
  if (run.phase() == RunPhase::kLeft) return {Level::kLook, WithProblem("is not followed", run)};
  if (run.phase() == RunPhase::kConnecting && !run.connection().problem.empty()) {
    return {Level::kLook, WithProblem("was not reached yet", run)};
  }
  return {};
}

std::string StopText(const RunView& run) {
  switch (run.stop().where) {
    case DebugStop::Where::kNowhere:
      return "";
    case DebugStop::Where::kBetweenTicks:
      return "PAUSED after tick " + std::to_string(run.stop().tick);
    case DebugStop::Where::kBefore:
      return "PAUSED before \"" + run.stop_path() + "\"";
    case DebugStop::Where::kAfter:
      return "PAUSED after \"" + run.stop_path() + "\"";
  }
  return "";
}

}  // namespace coppice::editor
