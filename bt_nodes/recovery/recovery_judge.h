// Did a recovery help? The one definition, in both readings of Stuede et al., ECMR 2021: it did if
// no further one was needed for the same subject within 60 s, and for the navigation "within a
// circle of radius 1 m within this time". The paper's words: a further one speaks against it if it
// is within the time and, for the navigation, within the circle; what comes later, or elsewhere, is
// a fault of its own. Strictly, as the published evaluation counts: within the time or, for the
// navigation, within the circle.
//
// Time and places are those of the events. Not thread-safe.
#ifndef COPPICE_BT_NODES_RECOVERY_RECOVERY_JUDGE_H_
#define COPPICE_BT_NODES_RECOVERY_RECOVERY_JUDGE_H_

#include <string>
#include <vector>

#include "bt_nodes/recovery/recovery_log.h"

namespace coppice::leaves {

struct JudgeOptions {
  double seconds = 60;
  double radius = 1;       ///< m, of the navigation; without a pose only the time counts
  bool is_strict = false;  ///< a further one within the time or the radius speaks against it
};

/// The judgement on one recovery that was carried out.
struct RecoveryVerdict {
  std::string recovery;
  std::string subject;
  int attempt = 1;
  Time ended{};
  bool helped = false;
};

class RecoveryJudge {
 public:
  explicit RecoveryJudge(JudgeOptions options = {}) : options_(options) {}

  /// Takes in an event, in the order of time; returns what is certain now. A recovery that could
  /// not be carried out has not helped, one that was interrupted is not judged.
  std::vector<RecoveryVerdict> Take(const RecoveryEvent& event);

  /// Nothing happened until `now`; returns what is certain now.
  std::vector<RecoveryVerdict> Advance(Time now);

  /// The end of all: what was still open has helped.
  std::vector<RecoveryVerdict> Finish();

 private:
  struct Open {
    RecoveryVerdict verdict;
    std::optional<Pose2D> pose;
  };
  bool SpeaksAgainst(const RecoveryEvent& event, const Open& open) const;
  bool IsLate(Time now, const Open& open) const;

  JudgeOptions options_;
  std::vector<Open> open_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_RECOVERY_RECOVERY_JUDGE_H_
