// What is known of a running robot from its topics, and what changed when.
#ifndef COPPICE_TESTS_SYSTEM_ROBOT_STATE_H_
#define COPPICE_TESTS_SYSTEM_ROBOT_STATE_H_

#include <coppice_msgs/Health.h>
#include <coppice_msgs/HealthEntry.h>
#include <coppice_msgs/HelpRequests.h>
#include <coppice_msgs/ProcessStates.h>
#include <coppice_msgs/RecoveryEvent.h>

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coppice::robot {

/// A moment on both time lines [s].
struct Instant {
  double wall = 0;
  double ros = 0;
};

/// One line of the record of a run.
struct Event {
  enum class Kind { kHealth, kProcess, kRequest, kRecovery, kConfiguration, kNote };
  Kind kind;
  std::string subject;  ///< "monitor subject", process, subject of the request, recovery
  int value = 0;        ///< level, state, phase of the recovery
  std::string text;
  double stamp = 0;  ///< ROS time that the sender gave to what it tells; 0: none
  Instant at;        ///< when it was heard
};

/// For people: "12.34 s health node /navigation 2: no answer".
std::string ToString(const Event& event, const Instant& origin);

/// Where the robot is, or is believed to be, frame map [m].
struct StampedPoint {
  double stamp = 0;  ///< ROS time
  double x = 0, y = 0;
};

class RobotState {
 public:
  using Key = std::pair<std::string, std::string>;  // monitor and subject

  void OnClock(const Instant& now);
  void OnHealth(const coppice_msgs::Health& message, const Instant& now);
  void OnProcesses(const coppice_msgs::ProcessStates& message, const Instant& now);
  void OnRequests(const coppice_msgs::HelpRequests& message, const Instant& now);
  void OnRecovery(const coppice_msgs::RecoveryEvent& message, const Instant& now);
  void OnApplication(const std::string& status, const Instant& now);
  void OnTruth(const StampedPoint& place);
  void OnBelief(const StampedPoint& place);
  void OnBattery(double current, const Instant& now);
  void Note(const std::string& text, const Instant& now);

  const Instant& now() const { return now_; }
  const std::string& application() const { return application_; }
  const std::string& configuration() const { return configuration_; }
  const StampedPoint& truth() const { return truth_; }
  /// How far from the truth the localization was, and when; compared at the same time stamps.
  double deviation() const { return deviation_; }
  double compared_at() const { return compared_at_; }
  bool charging() const { return charging_; }
  const std::map<Key, coppice_msgs::HealthEntry>& health() const { return health_; }
  const std::map<std::string, coppice_msgs::ProcessState>& processes() const { return processes_; }
  const std::vector<coppice_msgs::HelpRequest>& requests() const { return requests_; }
  const std::vector<Event>& events() const { return events_; }

  /// The level of what a monitor says; nothing if it does not speak of that.
  std::optional<int> Level(const std::string& monitor, const std::string& subject) const;
  /// pid of a process; 0 if it does not run.
  int Pid(const std::string& process) const;
  /// The same, but 0 as well if it is not ready.
  int ReadyPid(const std::string& process) const;
  bool IsAsked(const std::string& subject) const;

  /// All that is not as it should be: errors, processes that are not ready, open questions,
  /// recoveries under way, a tree that has ended. Empty: nominal. Not the computer's load.
  std::vector<std::string> Problems() const;
  /// Since when there are no problems without a break.
  const std::optional<Instant>& nominal_since() const { return nominal_since_; }

 private:
  void Add(Event::Kind kind, const std::string& subject, int value, const std::string& text,
           double stamp, const Instant& now);
  void Judge(const Instant& now);

  Instant now_;
  std::string application_;
  std::string configuration_;
  bool changing_ = false;
  StampedPoint truth_;
  std::deque<StampedPoint> beliefs_;  // the last ones
  double deviation_ = 0, compared_at_ = 0;
  bool charging_ = false;
  std::map<Key, coppice_msgs::HealthEntry> health_;
  std::map<std::string, coppice_msgs::ProcessState> processes_;
  std::vector<coppice_msgs::HelpRequest> requests_;
  std::vector<Event> events_;
  std::optional<Instant> nominal_since_;
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_SYSTEM_ROBOT_STATE_H_
