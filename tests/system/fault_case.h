// One fault from its injection to the end of its recovery: what the monitors saw and when, what was
// done against it, who was told, whether a person was asked, when all was well again.
//
// Each case adds a line to the report of the run (COPPICE_FAULT_REPORT, by default
// build/tests/system/faults.tsv), from which the table in docs/faults.md is made.
#ifndef COPPICE_TESTS_SYSTEM_FAULT_CASE_H_
#define COPPICE_TESTS_SYSTEM_FAULT_CASE_H_

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/system/robot_rig.h"

namespace coppice::robot {

/// A line of the report.
struct FaultReport {
  std::string fault, injection, detected_by, detected_after, limit, recovery, asked, nominal_after;
};
void WriteReport(const FaultReport& report);

class FaultCase {
 public:
  /// Waits until the robot is nominal; times count from then on, so inject the fault at once, or
  /// call Begin() right before. `fault` and `injection` are for the report.
  FaultCase(RobotRig& rig, std::string fault, std::string injection);
  /// Writes the report; shows the record of the run if the test has failed.
  ~FaultCase();

  void Begin() { begin_ = rig_.Now(); }
  /// Wall time instead of ROS time: for a fault that brings a new ROS master, hence a new ROS time.
  void CountWallTime() { wall_time_ = true; }
  const Instant& begin() const { return begin_; }

  /// Waits until a monitor says ERROR or worse of a subject, and expects that it measured that no
  /// later than `within` seconds of ROS time after the injection.
  bool ExpectDetected(const std::string& monitor, const std::string& subject, double within);
  /// The same for a level of one's choice (a warning is enough for what nobody can repair).
  bool ExpectLevel(const std::string& monitor, const std::string& subject, int level,
                   double within);

  /// Waits until the restart of a process has begun, and expects it no later than that many seconds
  /// of ROS time after the injection.
  bool ExpectRestartBegun(const std::string& process, double within);

  /// Waits until a process has another pid than before and is ready.
  bool ExpectRestarted(const std::string& process, double patience = 60);

  /// Waits until a person is asked about a subject.
  bool ExpectAsked(const std::string& subject, double patience);

  /// Waits until a message about it went to all of these supervisors, and expects that order.
  bool ExpectAskedInTurn(const std::string& subject, const std::vector<std::string>& supervisors,
                         double patience = 60);

  /// Waits until the request is in that state (coppice_msgs/HelpRequest).
  bool ExpectRequestEnded(const std::string& subject, int state, double patience = 60);

  /// Waits until nothing is wrong any more.
  bool ExpectNominal(double patience = 90);
  /// The same, at most so many seconds after the injection.
  bool ExpectNominalWithin(double seconds);

  /// Waits until the supervisors were told of what a monitor says, and the message was delivered
  /// (at the console).
  bool ExpectTold(const std::string& monitor, const std::string& subject, double patience = 60);

  /// Waits until /recovery/events has told this phase (coppice_msgs/RecoveryEvent) of a recovery.
  bool ExpectRecovery(const std::string& recovery, const std::string& subject, int phase,
                      double patience = 120);

  /// Since the beginning no process had another pid than before, but these.
  void ExpectOnlyRestarted(const std::set<std::string>& processes);
  void ExpectNobodyAsked();

  /// For the report, what a test has asserted by other means.
  void AddRecovery(const std::string& recovery);
  void SetAsked() { asked_ = true; }
  /// It was detected now; expects that this is not too late.
  void SetDetected(const std::string& by, double within);

 private:
  std::map<std::string, int> Pids() const;
  std::optional<Event> WaitForEvent(const std::function<bool(const Event&)>& is_it,
                                    double patience);
  double SecondsSince(double ros) const { return ros - begin_.ros; }
  double SecondsSince(const Instant& now) const {
    return wall_time_ ? now.wall - begin_.wall : now.ros - begin_.ros;
  }
  bool IsOfThis(const Event& event) const { return event.at.wall >= begin_.wall; }

  RobotRig& rig_;
  std::string fault_, injection_, detected_by_;
  std::string recovery_;  // what was asserted of it
  Instant begin_;
  std::map<std::string, int> pids_;  // of all processes that were ready at the beginning
  std::size_t logged_ = 0;           // of the console, at the beginning
  std::optional<double> detected_, limit_, nominal_;
  bool asked_ = false;
  bool wall_time_ = false;
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_SYSTEM_FAULT_CASE_H_
