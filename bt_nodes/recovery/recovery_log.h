// What was done against faults, as events: what Recovery and RestartFaultyNodes report, and what a
// robot makes of it (robot_app/ros publishes it on /recovery/events).
#ifndef COPPICE_BT_NODES_RECOVERY_RECOVERY_LOG_H_
#define COPPICE_BT_NODES_RECOVERY_RECOVERY_LOG_H_

#include <cstdint>
#include <optional>
#include <string>

#include "bt_core/base/clock.h"
#include "bt_nodes/navigation/pose2d.h"

namespace coppice::leaves {

enum class RecoveryPhase : std::uint8_t {
  kBegun,
  kSucceeded,    ///< carried out, and the fault was gone at its end
  kFailed,       ///< could not be carried out, or the fault was still there
  kInterrupted,  ///< by a more urgent fault, or with the tree
  kRefused,      ///< not begun, because the budget was used up
};

/// "begun", "succeeded", ...
const char* ToString(RecoveryPhase phase);

struct RecoveryEvent {
  std::string recovery;  ///< what is done: "wait_and_retry", "restart node", ...
  std::string subject;   ///< what it is done to: "navigation", "/docking", ...
  RecoveryPhase phase = RecoveryPhase::kBegun;
  int attempt = 1;             ///< within the budget's period, from 1
  Time time{};                 ///< of the tree's clock
  std::optional<Pose2D> pose;  ///< of the robot, in the map frame, if known
  std::string message;         ///< for people
};

class RecoveryLog {
 public:
  virtual ~RecoveryLog() = default;
  /// Called on the ticking thread; returns at once.
  virtual void Record(const RecoveryEvent& event) = 0;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_RECOVERY_RECOVERY_LOG_H_
