#include "tests/system/robot_state.h"

#include <cmath>
#include <cstdio>

namespace coppice::robot {
namespace {

using coppice_msgs::HealthEntry;
using coppice_msgs::HelpRequest;
using coppice_msgs::ProcessState;

constexpr double kSameMoment = 0.05;  // s
constexpr std::size_t kBeliefs = 20;

const char* NameOf(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::kHealth:
      return "health";
    case Event::Kind::kProcess:
      return "process";
    case Event::Kind::kRequest:
      return "request";
    case Event::Kind::kRecovery:
      return "recovery";
    case Event::Kind::kConfiguration:
      return "configuration";
    case Event::Kind::kNote:
      return "note";
  }
  return "";
}

// They may keep the computer busy for minutes.
bool IsOfOtherTests(const HealthEntry& entry) {
  return entry.monitor == "cpu" && entry.subject == "load";
}

}  // namespace

std::string ToString(const Event& event, const Instant& origin) {
  char times[64];
  std::snprintf(times, sizeof(times), "%8.2f s wall %8.2f s ROS  ", event.at.wall - origin.wall,
                event.at.ros - origin.ros);
  return times + std::string(NameOf(event.kind)) + " " + event.subject + " " +
         std::to_string(event.value) + (event.text.empty() ? "" : ": " + event.text);
}

void RobotState::Add(Event::Kind kind, const std::string& subject, int value,
                     const std::string& text, double stamp, const Instant& now) {
  events_.push_back({kind, subject, value, text, stamp, now});
}

// With a new ROS master time begins anew, and so does what is well.
void RobotState::OnClock(const Instant& now) {
  if (now.ros < now_.ros) nominal_since_.reset();
  now_ = now;
  Judge(now);
}

void RobotState::OnHealth(const coppice_msgs::Health& message, const Instant& now) {
  std::map<Key, HealthEntry> health;
  for (const HealthEntry& entry : message.entries) {
    const Key key{entry.monitor, entry.subject};
    const auto before = health_.find(key);
    const bool changed = before == health_.end() ? entry.level != HealthEntry::OK
                                                 : before->second.level != entry.level;
    if (changed) {
      Add(Event::Kind::kHealth, entry.monitor + " " + entry.subject, entry.level, entry.message,
          entry.stamp.toSec(), now);
    }
    health[key] = entry;
  }
  health_ = std::move(health);
  Judge(now);
}

void RobotState::OnProcesses(const coppice_msgs::ProcessStates& message, const Instant& now) {
  for (const ProcessState& process : message.processes) {
    const auto before = processes_.find(process.name);
    if (before == processes_.end() || before->second.state != process.state ||
        before->second.pid != process.pid) {
      Add(Event::Kind::kProcess, process.name, process.state, process.message,
          message.header.stamp.toSec(), now);
    }
    processes_[process.name] = process;
  }
  if (configuration_ != message.configuration) {
    Add(Event::Kind::kConfiguration, message.configuration, 0, "", message.header.stamp.toSec(),
        now);
  }
  configuration_ = message.configuration;
  changing_ = message.changing;
  Judge(now);
}

void RobotState::OnRequests(const coppice_msgs::HelpRequests& message, const Instant& now) {
  for (const HelpRequest& request : message.requests) {
    bool known = false;
    for (const HelpRequest& before : requests_) {
      known = known || (before.id == request.id && before.state == request.state);
    }
    if (!known) {
      Add(Event::Kind::kRequest, request.subject, request.state, request.question,
          message.header.stamp.toSec(), now);
    }
  }
  requests_ = message.requests;
  Judge(now);
}

void RobotState::OnApplication(const std::string& status, const Instant& now) {
  application_ = status;
  Judge(now);
}

void RobotState::OnRecovery(const coppice_msgs::RecoveryEvent& message, const Instant& now) {
  Add(Event::Kind::kRecovery, message.recovery + " of " + message.subject, message.phase,
      message.message, message.header.stamp.toSec(), now);
}

// The localization speaks of each scan, later than the truth of the same moment or earlier.
void RobotState::OnTruth(const StampedPoint& place) {
  truth_ = place;
  for (const StampedPoint& belief : beliefs_) {
    if (std::abs(belief.stamp - truth_.stamp) > kSameMoment) continue;
    deviation_ = std::hypot(belief.x - truth_.x, belief.y - truth_.y);
    compared_at_ = truth_.stamp;
  }
}

void RobotState::OnBelief(const StampedPoint& place) {
  beliefs_.push_back(place);
  if (beliefs_.size() > kBeliefs) beliefs_.pop_front();
  if (std::abs(place.stamp - truth_.stamp) <= kSameMoment) OnTruth(StampedPoint(truth_));
}

void RobotState::OnBattery(double current, const Instant& now) {
  const bool charging = current > 0;
  if (charging != charging_) {
    Add(Event::Kind::kNote, charging ? "current flows" : "no current", 0, "", now.ros, now);
  }
  charging_ = charging;
}

void RobotState::Note(const std::string& text, const Instant& now) {
  Add(Event::Kind::kNote, text, 0, "", now.ros, now);
}

std::optional<int> RobotState::Level(const std::string& monitor, const std::string& subject) const {
  const auto found = health_.find({monitor, subject});
  if (found == health_.end()) return std::nullopt;
  return found->second.level;
}

int RobotState::Pid(const std::string& process) const {
  const auto found = processes_.find(process);
  return found != processes_.end() ? found->second.pid : 0;
}

int RobotState::ReadyPid(const std::string& process) const {
  const auto found = processes_.find(process);
  return found != processes_.end() && found->second.state == ProcessState::READY ? found->second.pid
                                                                                 : 0;
}

bool RobotState::IsAsked(const std::string& subject) const {
  for (const HelpRequest& request : requests_) {
    if (request.subject == subject && request.state == HelpRequest::OPEN) return true;
  }
  return false;
}

std::vector<std::string> RobotState::Problems() const {
  std::vector<std::string> problems;
  if (health_.empty()) problems.push_back("nothing is heard from the monitors");
  for (const auto& [key, entry] : health_) {
    if (entry.level < HealthEntry::ERROR || IsOfOtherTests(entry)) continue;
    problems.push_back(entry.monitor + " " + entry.subject + ": " + entry.message);
  }
  if (processes_.empty()) problems.push_back("nothing is heard from the process supervisor");
  for (const auto& [name, process] : processes_) {
    if (process.state == ProcessState::READY || process.state == ProcessState::STOPPED) continue;
    problems.push_back("process " + name + " is in state " + std::to_string(process.state));
  }
  if (changing_) problems.push_back("the configuration is changing");
  for (const HelpRequest& request : requests_) {
    if (request.state == HelpRequest::OPEN)
      problems.push_back("a person is asked: " + request.subject);
  }
  if (application_ != "RUNNING") problems.push_back("the application is \"" + application_ + "\"");
  return problems;
}

void RobotState::Judge(const Instant& now) {
  if (!Problems().empty()) {
    nominal_since_.reset();
  } else if (!nominal_since_) {
    nominal_since_ = now;
  }
}

}  // namespace coppice::robot
