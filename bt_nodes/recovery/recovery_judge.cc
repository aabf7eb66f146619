#include "bt_nodes/recovery/recovery_judge.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coppice::leaves {
namespace {

// Else a program that is restarted while the robot drives would help whatever comes after.
constexpr const char* kPlaceCounts = "navigation";

}  // namespace

std::vector<RecoveryVerdict> RecoveryJudge::Take(const RecoveryEvent& event) {
  std::vector<RecoveryVerdict> verdicts = Advance(event.time);
  const auto decide = [&](const Open& open) {
    if (open.verdict.subject != event.subject) return false;
    const bool is_against = SpeaksAgainst(event, open);
    // Strictly, a later one at the same place would still speak against it.
    if (!is_against && !IsLate(event.time, open)) return false;
    verdicts.push_back(open.verdict);
    verdicts.back().helped = !is_against;
    return true;
  };
  const RecoveryVerdict verdict{event.recovery, event.subject, event.attempt, event.time, false};
  switch (event.phase) {
    case RecoveryPhase::kBegun:
      open_.erase(std::remove_if(open_.begin(), open_.end(), decide), open_.end());
      break;
    case RecoveryPhase::kSucceeded:
      open_.push_back({verdict, event.pose});
      break;
    case RecoveryPhase::kFailed:
      verdicts.push_back(verdict);
      break;
    case RecoveryPhase::kInterrupted:
    case RecoveryPhase::kRefused:
      break;
  }
  return verdicts;
}

bool RecoveryJudge::SpeaksAgainst(const RecoveryEvent& event, const Open& open) const {
  const bool is_soon = !IsLate(event.time, open);
  if (event.subject != kPlaceCounts || !event.pose || !open.pose) return is_soon;
  const double away = std::hypot(event.pose->x - open.pose->x, event.pose->y - open.pose->y);
  const bool is_near = away <= options_.radius;
  return options_.is_strict ? is_soon || is_near : is_soon && is_near;
}

bool RecoveryJudge::IsLate(Time now, const Open& open) const {
  return std::chrono::duration<double>(now - open.verdict.ended).count() > options_.seconds;
}

std::vector<RecoveryVerdict> RecoveryJudge::Advance(Time now) {
  std::vector<RecoveryVerdict> verdicts;
  if (options_.is_strict) return verdicts;  // only the next event can tell
  const auto decide = [&](const Open& open) {
    if (!IsLate(now, open)) return false;
    verdicts.push_back(open.verdict);
    verdicts.back().helped = true;
    return true;
  };
  open_.erase(std::remove_if(open_.begin(), open_.end(), decide), open_.end());
  return verdicts;
}

std::vector<RecoveryVerdict> RecoveryJudge::Finish() {
  std::vector<RecoveryVerdict> verdicts;
  for (const Open& open : open_) {
    verdicts.push_back(open.verdict);
    verdicts.back().helped = true;
  }
  open_.clear();
  return verdicts;
}

}  // namespace coppice::leaves
