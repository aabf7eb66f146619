#include "bt_nodes/application/application_leaves.h"

namespace coppice::leaves {

Status RequestCharge::Run() {
  const Duration again =
      std::chrono::duration_cast<Duration>(std::chrono::duration<double>(*period));
  const bool is_said = has_said_ && was_requested_ == *requested && now() - said_at_ < again;
  if (is_said) return Status::kSuccess;
  has_said_ = true;
  was_requested_ = *requested;
  said_at_ = now();
  application_.SetChargeRequested(was_requested_);
  return Status::kSuccess;
}

Status AnnounceGoingHome::Tick(Children& child, bool starting) {
  if (starting && ++*active_ == 1) application_.SetGoingHome(true);
  const Status result = child.Tick(0);
  if (result != Status::kRunning) End();
  return result;
}

Status SuspendApplication::Tick(Children& child, bool starting) {
  if (starting) application_.Suspend();
  const Status result = child.Tick(0);
  if (result != Status::kRunning) application_.Resume();
  return result;
}

}  // namespace coppice::leaves
