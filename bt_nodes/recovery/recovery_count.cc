#include "bt_nodes/recovery/recovery_count.h"

#include <algorithm>

#include "bt_nodes/recovery/recovery_judge.h"

namespace coppice::leaves {
namespace {

RecoveryCount& CountOf(const std::string& recovery, std::vector<RecoveryCount>& counts) {
  const auto known = std::find_if(counts.begin(), counts.end(), [&](const RecoveryCount& count) {
    return count.recovery == recovery;
  });
  if (known != counts.end()) return *known;
  counts.push_back({recovery});
  return counts.back();
}

void CountHelped(const std::vector<RecoveryEvent>& events, bool is_strict,
                 int RecoveryCount::*helped, std::vector<RecoveryCount>& counts) {
  RecoveryJudge judge({60, 1, is_strict});
  const auto add = [&](const std::vector<RecoveryVerdict>& verdicts) {
    for (const RecoveryVerdict& one : verdicts) {
      CountOf(one.recovery, counts).*helped += one.helped;
    }
  };
  for (const RecoveryEvent& event : events) add(judge.Take(event));
  add(judge.Finish());
}

}  // namespace

std::vector<RecoveryCount> CountRecoveries(const std::vector<RecoveryEvent>& events) {
  std::vector<RecoveryCount> counts;
  for (const RecoveryEvent& event : events) {
    RecoveryCount& count = CountOf(event.recovery, counts);
    count.begun += event.phase == RecoveryPhase::kBegun;
    count.succeeded += event.phase == RecoveryPhase::kSucceeded;
  }
  CountHelped(events, false, &RecoveryCount::helped, counts);
  CountHelped(events, true, &RecoveryCount::helped_strictly, counts);
  return counts;
}

}  // namespace coppice::leaves
