// The world of a deployment as numbers: the file scenario.yaml. Every rate and every share stands
// there with where it is from. How long the robot's own actions take is said beside them.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_SCENARIO_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_SCENARIO_H_

#include <array>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/deployment/scenario/calendar.h"

namespace coppice::robot::deployment {

/// What can go wrong. Each can be left out (--without) and happen more often (--times).
enum class Fault : std::uint8_t {
  kBlockage,      ///< something holds the robot for longer than its navigation waits; per moving h
  kLocalization,  ///< the position is lost; per moving h
  kProgram,       ///< a program ends or hangs; per moving h
  kTopic,         ///< a program's topics fall silent or slow down; per moving h
  kCrashLoop,     ///< a program crashes after every start; per deployment of 12 days
  kChargeSignal,  ///< the application no longer hears how the battery is; per deployment
  kDocking,       ///< an attempt does not reach the station; probability per attempt
  kNoCurrent,     ///< contact is made, but no current flows; probability per docking
  kNetwork,       ///< no message reaches a person; per deployment
};
inline constexpr int kFaults = 9;

/// "blockage", "localization", ... as in the file.
const char* ToString(Fault fault);

/// A number of the file as it is written there, for the report.
struct SourcedNumber {
  std::string name;
  double value = 0;
  std::string unit;
  std::string source;
};

/// See scenario.yaml for what each number means. Times in s unless the file says otherwise.
struct Scenario {
  Calendar calendar;
  std::array<double, kFaults> rates{};
  double rate(Fault fault) const { return rates[static_cast<std::size_t>(fault)]; }

  double blockage_passing = 0, blockage_trap = 0;
  double again_after_passing = 0, again_after_trap = 0;
  double passing_shortest = 0, passing_longest = 0, people_noticed = 0;
  double closed_at_door = 0, closed_lasts = 0;
  double lost_transient = 0, lost_inside = 0;
  double hang_share = 0;
  double loop_crash_earliest = 0, loop_crash_latest = 0, loop_takes_others = 0;
  double loop_in_program = 0, loop_noticed_after = 0;
  double docking_persistent = 0, no_current_press_on = 0;
  double network_median = 0;
  double answer_median = 0, answer_sigma = 0, answer_never = 0;
  double service_shortest = 0, service_longest = 0;
  double notice_after = 0, notice_median = 0, low_battery_seen = 0;
  double operator_from = 0, operator_to = 0;
  double effective_speed = 0, command_speed = 0;
  double faces_per_hour = 0, faces_without_mask = 0;
  double program_start_shortest = 0, program_start_longest = 0;
  std::vector<double> people_by_hour;  ///< weights of the hours of a day, from midnight

  std::vector<SourcedNumber> numbers;  ///< all of them, in the order of the file
};

/// Reads and checks a file. All that is wrong is reported at once; with errors the result is not to
/// be used.
Scenario LoadScenario(const std::string& path, Diagnostics& diagnostics);

/// Leaves a fault out. A problem if there is no such one, with the nearest name.
Outcome Without(const std::string& fault, Scenario& scenario);
/// All faults so many times as often; probabilities stay below 1.
void MultiplyFaults(double factor, Scenario& scenario);
/// Ends after so many days from the first midnight on.
Outcome Shorten(int days, Scenario& scenario);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_SCENARIO_H_
