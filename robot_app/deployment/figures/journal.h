// One deployment of a robot as it happened, as plain values. Every figure and every picture of the
// report follows from it; nothing that can be worked out is kept.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_JOURNAL_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_JOURNAL_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_nodes/recovery/recovery_log.h"
#include "robot_app/deployment/scenario/calendar.h"

namespace coppice::robot::deployment {

/// What the robot is about. The first three are on the station.
enum class Activity : std::uint8_t {
  kFull,        ///< on the station with a full battery
  kCharging,    ///< current flows
  kNoCurrent,   ///< on the station, but no current flows
  kMoving,      ///< off the station, able to do its work
  kRecovering,  ///< off the station, in an error or a recovery
  kAsking,      ///< off the station, waits for a person
  kOff,         ///< switched off
};
inline constexpr int kActivities = 7;

/// "charging", ...
const char* ToString(Activity activity);
bool IsUndocked(Activity activity);

struct Span {
  Interval when;
  Activity activity = Activity::kFull;
};

/// A person came who was not asked for.
struct UnplannedStop {
  Time at{};
  std::string cause;  ///< the fault behind it: "docking", "charge signal", ...
  std::string what;   ///< what the person found, for people
};

/// The robot asked for a person.
struct Request {
  std::string subject;
  Time asked{};
  Time closed = kNever;   ///< answered, withdrawn, or nobody waited any more
  bool is_fixed = false;  ///< by a person
  std::string outcome;    ///< for people
};

/// Going onto the station, from the first attempt to current or the end of it.
struct Docking {
  Time begun{};
  int attempts = 0;
  bool is_docked = false;    ///< the robot took it for done
  bool has_current = false;  ///< and current flowed
  double seconds = 0;        ///< until then
};

/// A program was started again.
struct ProgramStart {
  std::string group;
  Time failed{};
  double seconds = 0;  ///< from the fault to readiness (MTTR)
  std::string fault;   ///< "exit", "hang", ...
};

/// What went wrong in the world, whatever the robot noticed of it.
struct OccurredFault {
  Time at{};
  std::string fault;  ///< "blockage", ... as in scenario.yaml
  std::string what;   ///< its kind: "passing", "trap", a door, "transient", a node ...
  double lasts = 0;   ///< s; 0: until something is done about it
};

struct BatterySample {
  Time at{};
  double level = 0;  ///< 0..1
};

struct Journal {
  std::string controller;  ///< "ours", "published", "ours-without-watchdog", ...
  std::uint64_t seed = 0;
  double times = 1;                  ///< the rates of all faults, times this
  std::vector<std::string> without;  ///< faults that were left out
  Interval span;
  std::vector<Interval> duties;  ///< when it was on duty
  std::vector<Span> spans;       ///< without gaps
  std::vector<Interval> stands;  ///< off the station without getting on, for 30 s and more
  std::vector<leaves::RecoveryEvent> recoveries;
  std::vector<Request> requests;
  std::vector<UnplannedStop> stops;
  std::vector<Docking> dockings;
  std::vector<ProgramStart> starts;
  std::vector<OccurredFault> faults;
  std::vector<BatterySample> battery;
  double distance = 0;  ///< m
  int with_mask = 0;    ///< faces seen
  int without_mask = 0;
  double cpu_seconds = 0;            ///< that it took to calculate
  std::vector<std::string> records;  ///< file names beside the run's
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_JOURNAL_H_
