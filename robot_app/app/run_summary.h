// What a run was like, read from its two records alone: rounds, faults, recoveries by kind, ticks.
#ifndef COPPICE_ROBOT_APP_APP_RUN_SUMMARY_H_
#define COPPICE_ROBOT_APP_APP_RUN_SUMMARY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/frames/history.h"
#include "bt_nodes/navigation/pose2d.h"
#include "bt_nodes/recovery/recovery_count.h"

namespace coppice::robot {

/// What counts in one record.
struct RecordedEvents {
  struct Change {
    Time time;
    StatusChange change;
  };
  struct Stay {
    Time since;
    leaves::Pose2D pose;
  };
  TreeDescription tree;
  Time begin{};
  Time end{};  ///< of the last entry
  std::uint64_t ticks = 0;
  std::vector<Change> changes;
  std::vector<NodeMessage> messages;
  std::vector<HistoryNote> notes;
  std::vector<Stay> stays;  ///< of the robot, in the order of time, as the tree knew it
};

struct TickStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t status_changes = 0;
  double seconds = 0;  ///< from the start of the record to its last entry, in the tree's time
};

struct RunSummary {
  int rounds = 0;                                 ///< patrol rounds that were completed
  int stops = 0;                                  ///< places that were reached
  bool docked = false;                            ///< the robot came home at the end
  std::vector<std::string> injected;              ///< notes about injected faults
  std::vector<std::string> faults;                ///< what the monitor tree saw, each text once
  std::vector<leaves::RecoveryCount> recoveries;  ///< those that happened
  TickStatistics application;
  TickStatistics monitor;
  std::vector<std::string> problems;  ///< a record that is missing or damaged

  /// The count of that kind; zeros if there is none.
  leaves::RecoveryCount Recovery(const std::string& kind) const;
};

/// Counts what two recordings say.
RunSummary Summarize(const RecordedEvents& application, const RecordedEvents& monitor);

/// Reads both records and counts. Never throws: what is wrong is in `problems`.
RunSummary SummarizeFiles(const std::string& application_record, const std::string& monitor_record);

/// The summary for people. `distance` was driven [m], from odometry.
std::string ToTable(const RunSummary& summary, double distance);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_RUN_SUMMARY_H_
