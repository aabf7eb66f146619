#include "bt_nodes/recovery/recovery_nodes.h"

#include <cmath>

namespace coppice::leaves {

Status ContinueEpisode::Run() {
  const bool is_over = !last_ || std::chrono::duration<double>(now() - *last_).count() > *seconds ||
                       IsAnotherPlace();
  if (is_over) rung.Set(0);
  last_ = now();
  if (pose.has_value()) last_pose_ = *pose;
  return Status::kSuccess;
}

bool ContinueEpisode::IsAnotherPlace() const {
  if (*radius <= 0 || !last_pose_ || !pose.has_value()) return false;
  return std::hypot(pose->x - last_pose_->x, pose->y - last_pose_->y) > *radius;
}

Duration Recovery::Period() const {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(*period));
}

Status Recovery::Tick(Children& child, bool starting) {
  if (starting) {
    const bool was_refused = is_refused_;
    is_refused_ = !budget_.Take(now(), *times, Period());
    if (is_refused_) {
      if (!was_refused) Record(RecoveryPhase::kRefused);
      return Fail(*recovery + ": the budget is used up");
    }
    attempt_ = budget_.used(now(), Period());
    Record(RecoveryPhase::kBegun);
  }
  const Status result = child.Tick(0);
  if (result == Status::kSuccess) Record(RecoveryPhase::kSucceeded);
  if (result == Status::kFailure) Record(RecoveryPhase::kFailed);
  if (result == Status::kSkipped) Record(RecoveryPhase::kInterrupted);
  return result;
}

void Recovery::Record(RecoveryPhase phase) {
  RecoveryEvent event{*recovery, *subject, phase, attempt_, now(), std::nullopt, ""};
  if (pose.has_value()) event.pose = *pose;
  log_.Record(event);
}

}  // namespace coppice::leaves
