#include "bt_nodes/operators/tell_faults.h"

#include <algorithm>

namespace coppice::leaves {
namespace {

Duration Seconds(double seconds) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Status TellFaults::Run() {
  for (const HealthEntry& entry : health->entries) {
    if (IsTold(entry)) Note(entry);
  }
  for (Fault& fault : faults_) {
    Tell(fault);
    TellIfGone(fault);
  }
  // Kept until a new message may be sent, so that a fault that flickers is told once.
  const auto is_over = [this](const Fault& fault) {
    return HasGone(fault) && now() >= fault.rest_until;
  };
  faults_.erase(std::remove_if(faults_.begin(), faults_.end(), is_over), faults_.end());
  return Status::kSuccess;
}

bool TellFaults::IsTold(const HealthEntry& entry) const {
  const bool is_fault =
      entry.level == HealthLevel::kError || (entry.level == HealthLevel::kStale && *stale);
  return is_fault && (only->empty() || ListsKind(*only, entry.monitor)) &&
         !ListsKind(*except, entry.monitor);
}

void TellFaults::Note(const HealthEntry& entry) {
  auto fault = std::find_if(faults_.begin(), faults_.end(), [&](const Fault& known) {
    return known.monitor == entry.monitor && known.subject == entry.subject;
  });
  if (fault == faults_.end()) {
    fault = faults_.insert(faults_.end(),
                           {entry.monitor, entry.subject, "", now(), now(), Time{}, false});
  }
  if (HasGone(*fault)) fault->begun = now();
  fault->seen = now();
  fault->message = entry.message;
}

void TellFaults::Tell(Fault& fault) {
  const bool is_there = fault.seen == now();
  if (!is_there || fault.is_told || now() < fault.rest_until) return;
  if (now() - fault.begun < Seconds(*lasting)) return;
  fault.is_told = true;
  fault.rest_until = now() + Seconds(*cooldown);
  channel_.Tell(fault.monitor + " " + fault.subject, fault.message);
}

void TellFaults::TellIfGone(Fault& fault) {
  if (!fault.is_told || !HasGone(fault)) return;
  fault.is_told = false;
  channel_.Tell(fault.monitor + " " + fault.subject, "has gone");
}

bool TellFaults::HasGone(const Fault& fault) const { return now() - fault.seen > Seconds(*clear); }

}  // namespace coppice::leaves
