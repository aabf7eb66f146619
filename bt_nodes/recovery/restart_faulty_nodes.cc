#include "bt_nodes/recovery/restart_faulty_nodes.h"

namespace coppice::leaves {
namespace {

Duration Seconds(double seconds) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Status RestartFaultyNodes::OnRunning() {
  if (!repairs_)
    repairs_.emplace(RepairOptions{Seconds(*grace), *times, Seconds(*period), Seconds(*again)});
  TakeInHealth();
  TakeAnswer();
  RestartNext();
  const std::string left = repairs_->given_up();
  if (left != told_) given_up.Set(told_ = left);
  if (asked_ || repairs_->is_busy()) return Status::kRunning;
  return repairs_->has_faults() ? Status::kFailure : Status::kSuccess;
}

void RestartFaultyNodes::TakeInHealth() {
  for (const RepairOutcome& ended : repairs_->Update(now(), *health, *kinds)) {
    Record(ended, ended.is_well ? RecoveryPhase::kSucceeded : RecoveryPhase::kFailed);
  }
}

void RestartFaultyNodes::TakeAnswer() {
  const ActionResult* answer = answer_.Take();
  if (!answer || !asked_) return;
  if (answer->ok) {
    repairs_->Began(asked_->node, now());
  } else {
    repairs_->Refused(asked_->node, now());
    Record(*asked_, RecoveryPhase::kFailed, answer->message);
    Say(asked_->node + ": " + answer->message);
  }
  asked_.reset();
}

// One after the other: the process supervisor works on one request at a time anyway.
void RestartFaultyNodes::RestartNext() {
  if (asked_) return;
  asked_ = repairs_->Next(now());
  if (!asked_) return;
  Record(*asked_, RecoveryPhase::kBegun);
  processes_.RestartNode(asked_->node, false, answer_.NewSender());
}

void RestartFaultyNodes::Record(const RepairOutcome& repair, RecoveryPhase phase,
                                const std::string& message) {
  RecoveryEvent event{"restart node", repair.node,  phase,  repair.attempt,
                      now(),          std::nullopt, message};
  if (pose.has_value()) event.pose = *pose;
  log_.Record(event);
}

}  // namespace coppice::leaves
