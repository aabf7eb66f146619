#include "bt_nodes/processes/process_leaves.h"

namespace coppice::leaves {

Status SwitchConfiguration::Run() {
  if (current.has_value() && *current == *configuration) {
    asked_for_.clear();
    return Status::kSuccess;
  }
  const Duration period_ns =
      std::chrono::duration_cast<Duration>(std::chrono::duration<double>(*period));
  const bool asked_recently = asked_for_ == *configuration && now() - asked_at_ < period_ns;
  if (asked_recently) return Status::kSuccess;
  asked_for_ = *configuration;
  asked_at_ = now();
  processes_.SetConfiguration(*configuration);
  return Status::kSuccess;
}

}  // namespace coppice::leaves
