#include "bt_nodes/basics/wait.h"

#include <cmath>

namespace coppice::leaves {

Status Wait::OnStart() {
  if (!std::isfinite(*seconds) || *seconds > 1e9) return Fail("seconds must be a finite number");
  end_ = now() + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(*seconds));
  return OnRunning();
}

Status Wait::OnRunning() {
  if (now() >= end_) return Status::kSuccess;
  WakeAt(end_);
  return Status::kRunning;
}

}  // namespace coppice::leaves
