// What a run was like, read from its two records alone: rounds, faults, recoveries by kind, ticks.
#ifndef COPPICE_ROBOT_APP_APP_RUN_SUMMARY_H_
#define COPPICE_ROBOT_APP_APP_RUN_SUMMARY_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace coppice::robot {

/// One kind of recovery, for example "wait_and_retry".
struct RecoveryCount {
  int started = 0;
  int ended_well = 0;  ///< the tree saw the fault disappear
  int successful =
      0;  ///< and no further recovery was needed within 60 s (Hawes 2016, used by Sobi)
};

struct TickStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t status_changes = 0;
  double seconds = 0;  ///< from the first to the last recorded tick, in the tree's time
};

struct RunSummary {
  int rounds = 0;                   ///< patrol rounds that were completed
  int stops = 0;                    ///< places that were reached
  bool docked = false;              ///< the robot came home
  std::vector<std::string> faults;  ///< what the monitors reported as errors, first message of each
  std::map<std::string, RecoveryCount> recoveries;
  TickStatistics application;
  TickStatistics monitor;
  std::vector<std::string> problems;  ///< a record that is missing or damaged

  /// Recoveries that ended well, of all kinds.
  int SuccessfulRecoveries() const;
};

/// Reads both records. Never throws: what is wrong is in `problems`.
RunSummary Summarize(const std::string& application_record, const std::string& monitor_record);

/// The summary for people.
std::string ToTable(const RunSummary& summary, int injected_faults, double distance);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_RUN_SUMMARY_H_
