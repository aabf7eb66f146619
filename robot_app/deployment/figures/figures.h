// The figures of a deployment, exactly as Stuede et al., "Sobi", ECMR 2021, and its evaluation
// scripts define them:
//
//   A%   mean time in motion per working day over 8 h. In motion: off the station, able to do its
//        work, not in an error or recovery state. By the scripts: off the station, but for gaps of
//        30 to 400 s without feedback of the navigation.
//   TSL  total system lifetime: from the start to the first intervention that the robot had not
//        asked for, from each to the next, from the last to the end; weekends (48 h) do not count.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_FIGURES_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_FIGURES_H_

#include <string>
#include <vector>

#include "bt_nodes/recovery/recovery_count.h"
#include "robot_app/deployment/figures/journal.h"

namespace coppice::robot::deployment {

/// Hours of an office day.
inline constexpr double kWorkday = 8;

struct Lifetimes {
  std::vector<double> hours;  ///< one more than there are interventions
  double mean() const;
  double most() const;
  double sum() const;
};
Lifetimes LifetimesOf(const Journal& journal);

/// One kind of recovery, in both readings of success (bt_nodes/recovery/recovery_judge.h).
struct RecoveryRow {
  std::string recovery;
  int count = 0;
  int helped = 0;           ///< none was needed within a minute (and a metre)
  int helped_strictly = 0;  ///< none within a minute, and none within a metre
};

struct Figures {
  int working_days = 0;
  double undocked = 0;        ///< h
  double moving = 0;          ///< h
  double moving_by_gaps = 0;  ///< h, as the scripts count
  double charging = 0;        ///< h on the station
  double extra_charging = 0;  ///< h of it while on duty
  double distance = 0;        ///< km
  Lifetimes lifetimes;
  std::vector<RecoveryRow> recoveries;
  int dockings = 0;          ///< attempts, each from its approach on
  int good_dockings = 0;     ///< with current
  int docking_episodes = 0;  ///< visits of the station
  int good_docking_episodes = 0;
  int requests = 0;
  int answered = 0;           ///< requests that a person fixed
  double answer_minutes = 0;  ///< mean, of those
  int stops = 0;

  double autonomy() const;  ///< A%, in percent
  double autonomy_by_gaps() const;
};
Figures FiguresOf(const Journal& journal);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_FIGURES_H_
