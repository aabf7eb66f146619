// Which of several faulty nodes is restarted next, and which are left to a person. One node that
// does not come back never hides another.
//
// For each node: it is restarted, then has some time to become well; if it does not, it is
// restarted again, until the restart is refused or the budget is used up. Then the node is given
// up: a person is needed, and only now and then it is tried once more.
//
// Time is that of the caller and never goes back. Not thread-safe.
#ifndef COPPICE_BT_NODES_RECOVERY_NODE_REPAIRS_H_
#define COPPICE_BT_NODES_RECOVERY_NODE_REPAIRS_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_nodes/monitoring/health.h"
#include "bt_nodes/recovery/budget.h"

namespace coppice::leaves {

struct RepairOptions {
  Duration grace = std::chrono::seconds(60);    ///< after a restart, until the node must be well
  int times = 10;                               ///< budget of one node: so many restarts ...
  Duration period = std::chrono::seconds(600);  ///< ... in so long
  Duration again = std::chrono::seconds(60);    ///< a node that was given up is tried again
};

/// The end of a restart that had begun.
struct RepairOutcome {
  std::string node;
  int attempt = 1;
  bool is_well = false;
};

class NodeRepairs {
 public:
  explicit NodeRepairs(RepairOptions options = {}) : options_(options) {}

  /// Takes in which nodes are faulty now: those that entries of one of the kinds (separated by
  /// semicolons) blame. Returns the restarts that have come to their end.
  std::vector<RepairOutcome> Update(Time now, const Health& health, std::string_view kinds);

  /// The node to restart now, with the number of the attempt; none if all are in hand. Counts
  /// against its budget. Began() or Refused() must follow before the next call.
  std::optional<RepairOutcome> Next(Time now);
  void Began(const std::string& node, Time now);
  void Refused(const std::string& node, Time now);

  /// True while something can be done about some faulty node, or is being done.
  bool is_busy() const;
  /// True while some node is faulty.
  bool has_faults() const;
  /// The faulty nodes that need a person, separated by commas.
  std::string given_up() const;

 private:
  enum class State : std::uint8_t { kFaulty, kComingUp, kGivenUp, kWell };
  struct Repair {
    std::string node;
    State state = State::kFaulty;
    Time until{};  // coming up: must be well by then; given up: tried again then
    int attempt = 0;
    bool is_blamed = true;
    bool can_restart = true;  // else nobody knows which node it is
    Budget budget;
  };

  void Blame(const HealthEntry& entry);
  void Settle(Time now, Repair& repair, std::vector<RepairOutcome>& outcomes) const;
  void GiveUp(Repair& repair, Time now) const;
  Repair* Find(const std::string& node);

  RepairOptions options_;
  std::vector<Repair> repairs_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_RECOVERY_NODE_REPAIRS_H_
