// One fault from its injection to the end of its recovery: what the monitors saw and when, who was
// restarted, whether a person was asked, when all was well again.
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

  /// Waits until nothing is wrong any more.
  bool ExpectNominal(double patience = 90);

  /// Since the beginning no process had another pid than before, but these.
  void ExpectOnlyRestarted(const std::set<std::string>& processes);
  void ExpectNobodyAsked();

  /// What was done against it, for the report.
  void set_recovery(const std::string& recovery) { recovery_ = recovery; }

 private:
  std::map<std::string, int> Pids() const;
  std::optional<Event> WaitForEvent(const std::function<bool(const Event&)>& is_it,
                                    double patience);
  double SecondsSince(double ros) const { return ros - begin_.ros; }

  RobotRig& rig_;
  std::string fault_, injection_, recovery_, detected_by_;
  Instant begin_;
  std::map<std::string, int> pids_;  // of all processes that were ready at the beginning
  std::optional<double> detected_, limit_, nominal_;
  bool asked_ = false;
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_SYSTEM_FAULT_CASE_H_
