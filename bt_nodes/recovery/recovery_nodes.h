// The parts of a ladder of recoveries, one rung after the other in a Fallback:
//
//   <ReactiveSequence>
//     <ContinueEpisode rung="{rung}" pose="{pose}"/>
//     <Fallback>
//       <Recovery recovery="wait"    subject="navigation" _skipIf="rung &gt;= 1" _post="rung = 1">
//       ... <Recovery recovery="back up" subject="navigation" _skipIf="rung &gt;= 2" _post="rung =
//       2"> ... <RequestHelp subject="navigation" question="..." _onSuccess="rung = 0"/>
//     </Fallback>
//   </ReactiveSequence>
//
// A fault that comes back soon after a rung goes on with the next one, however often it flickers.
#ifndef COPPICE_BT_NODES_RECOVERY_RECOVERY_NODES_H_
#define COPPICE_BT_NODES_RECOVERY_RECOVERY_NODES_H_

#include <optional>
#include <string>

#include "bt_core/nodes/user_control.h"
#include "bt_nodes/navigation/pose2d.h"
#include "bt_nodes/recovery/budget.h"
#include "bt_nodes/recovery/recovery_log.h"

namespace coppice::leaves {

/// The memory of a ladder. The episode goes on as long as the ladder is needed again within the
/// time and the distance of the criterion of success.
class ContinueEpisode : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Sets the ladder back to its first rung, unless it was needed shortly before at about the "
      "same place. To be ticked in every tick of the ladder. Always succeeds.";
  Input<Pose2D> pose{this, "pose", "of the robot, fed from outside", kOptional};
  Input<double> seconds{this, "seconds", "so long without the ladder end an episode [s]", 60};
  Input<double> radius{this, "radius", "so far away is another episode [m]; 0: only time counts",
                       1};
  Output<int> rung{this, "rung", "0 in a new episode, else left as it is"};
  Status Run() override;

 private:
  bool IsAnotherPlace() const;

  std::optional<Time> last_;  // tick
  std::optional<Pose2D> last_pose_;
};

class Recovery : public UserDecorator {
 public:
  static constexpr const char* kDescription =
      "One recovery: records its begin and how it ended, and fails without trying when its budget "
      "is used up. The result is the child's.";
  explicit Recovery(RecoveryLog& log) : log_(log) {}
  Input<std::string> recovery{this, "recovery", "what is done"};
  Input<std::string> subject{this, "subject", "what it is done to"};
  Input<Pose2D> pose{this, "pose", "of the robot, fed from outside", kOptional};
  Input<int> times{this, "times", "budget: no more than so many ...", 10};
  Input<double> period{this, "period", "... in so long [s]", 600};
  Status Tick(Children& child, bool starting) override;
  void OnHalted() override { Record(RecoveryPhase::kInterrupted); }

 private:
  void Record(RecoveryPhase phase);
  Duration Period() const;

  RecoveryLog& log_;
  Budget budget_;
  int attempt_ = 0;
  bool is_refused_ = false;  // the last time
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_RECOVERY_RECOVERY_NODES_H_
