// TellFaults: messages about faults that the robot itself can do nothing about.
#ifndef COPPICE_BT_NODES_OPERATORS_TELL_FAULTS_H_
#define COPPICE_BT_NODES_OPERATORS_TELL_FAULTS_H_

#include <string>
#include <vector>

#include "bt_core/nodes/leaf.h"
#include "bt_nodes/monitoring/health.h"
#include "bt_nodes/operators/supervisor_channel.h"

namespace coppice::leaves {

/// One message for each fault that lasts, not more often than the cooldown, and one when it has
/// gone. To be ticked all the time; it ends at once and never stands in the way of others.
class TellFaults : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Tells the supervisors once of every lasting error of some kinds of monitors, and when it "
      "has gone. Always succeeds.";
  explicit TellFaults(SupervisorChannel& channel) : channel_(channel) {}
  Input<Health> health{this, "health", "from ReadHealth"};
  Input<std::string> only{this, "only", "these kinds of monitors; empty: all", ""};
  Input<std::string> except{this, "except", "kinds of monitors that are no business of this node",
                            ""};
  Input<bool> stale{this, "stale", "tells also of what nobody knows, as its monitor is silent",
                    true};
  Input<double> lasting{this, "lasting", "told when it has lasted so long [s]", 5};
  Input<double> clear{this, "clear", "has gone when it was not there for so long [s]", 30};
  Input<double> cooldown{this, "cooldown", "no two messages about one fault within this [s]", 600};
  Status Run() override;

 private:
  struct Fault {
    std::string monitor;
    std::string subject;
    std::string message;
    Time begun{};
    Time seen{};
    Time rest_until{};
    bool is_told = false;
  };
  bool IsTold(const HealthEntry& entry) const;
  void Note(const HealthEntry& entry);
  void Tell(Fault& fault);
  void TellIfGone(Fault& fault);
  bool HasGone(const Fault& fault) const;

  SupervisorChannel& channel_;
  std::vector<Fault> faults_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_OPERATORS_TELL_FAULTS_H_
