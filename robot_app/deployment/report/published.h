// What Stuede et al., "Sobi", ECMR 2021, report of their deployment of 16 days: Tables II and III.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_PUBLISHED_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_PUBLISHED_H_

namespace coppice::robot::deployment {

/// A row of Table III. `recovery`: its name in the trees; the requests of ours have none there, and
/// are counted by `subject`.
struct PublishedRecovery {
  const char* type;
  const char* reaction;
  const char* recovery;
  const char* subject;  ///< of the request; null: it is none
  int count;
  int helped;
};
inline constexpr PublishedRecovery kPublishedRecoveries[] = {
    {"ROS", "restart node", "restart node", nullptr, 32, 20},
    {"navigation", "wait and retry", "wait and retry", nullptr, 194, 137},
    {"navigation", "move backwards", "move backwards", nullptr, 41, 20},
    {"navigation", "ask supervisor for teleoperation", "", "navigation", 5, 5},
    {"localization", "slow rotate", "slow rotate", nullptr, 76, 64},
    {"localization", "restart localization and rotate", "restart localization and rotate", nullptr,
     12, 8},
    {"localization", "ask supervisor for relocalization", "", "localization", 4, 4},
};

/// Table II, and what the text says.
struct PublishedMetrics {
  double operating = 5.9;  ///< h a day
  double moving = 5.5;     ///< h a day
  double autonomy = 69;    ///< %; 68.1 by the exact figures
  double distance = 66.6;  ///< km
  double mean_tsl = 56.7;  ///< h
  double max_tsl = 90.6;   ///< h
  int with_mask = 983;
  int without_mask = 101;
  int stops = 4;
  int requests = 9;
  int dockings = 28;
  int good_dockings = 27;
  double extra_charging = 2.0;  ///< h a day
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_PUBLISHED_H_
