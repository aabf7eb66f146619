#include "tests/system/fault_case.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

constexpr double kDetectionPatience = 120;  // s, wall; the measured time is judged, not this
constexpr char kConsole[] = "assistance";   // prints what supervisors are told

std::string ReportFile() {
  const char* file = std::getenv("COPPICE_FAULT_REPORT");
  return file != nullptr ? file : BinaryFolder() + "/tests/system/faults.tsv";
}

std::string Seconds(const std::optional<double>& seconds) {
  if (!seconds) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << *seconds;
  return text.str();
}

}  // namespace

void WriteReport(const FaultReport& r) {
  std::ofstream file(ReportFile(), std::ios::app);
  for (const std::string* field : {&r.fault, &r.injection, &r.detected_by, &r.detected_after,
                                   &r.limit, &r.recovery, &r.asked}) {
    file << *field << '\t';
  }
  file << r.nominal_after << '\n';
}

FaultCase::FaultCase(RobotRig& rig, std::string fault, std::string injection)
    : rig_(rig), fault_(std::move(fault)), injection_(std::move(injection)) {
  rig_.WaitUntilNominal(kDetectionPatience);
  pids_ = Pids();
  logged_ = rig_.Logged(kConsole).size();
  begin_ = rig_.Now();
}

FaultCase::~FaultCase() {
  if (testing::Test::HasFailure()) {
    ADD_FAILURE() << fault_ << ", what happened:\n"
                  << rig_.TimelineSince(begin_) << "logs: " << rig_.folder();
    return;
  }
  if (std::uncaught_exceptions() > 0) return;
  WriteReport({fault_, injection_, detected_by_, Seconds(detected_), Seconds(limit_), recovery_,
               asked_ ? "yes" : "no", Seconds(nominal_)});
}

std::map<std::string, int> FaultCase::Pids() const {
  return rig_.With([](const RobotState& state) {
    std::map<std::string, int> pids;
    for (const auto& [name, process] : state.processes()) {
      if (const int pid = state.ReadyPid(name)) pids[name] = pid;
    }
    return pids;
  });
}

bool FaultCase::ExpectDetected(const std::string& monitor, const std::string& subject,
                               double within) {
  return ExpectLevel(monitor, subject, coppice_msgs::HealthEntry::ERROR, within);
}

// The first one since the injection.
std::optional<Event> FaultCase::WaitForEvent(const std::function<bool(const Event&)>& is_it,
                                             double patience) {
  std::optional<Event> found;
  rig_.WaitFor(
      [&](const RobotState& state) {
        for (const Event& event : state.events()) {
          if (!IsOfThis(event) || !is_it(event)) continue;
          found = event;
          return true;
        }
        return false;
      },
      patience);
  return found;
}

bool FaultCase::ExpectLevel(const std::string& monitor, const std::string& subject, int level,
                            double within) {
  const std::string what = monitor + " " + subject;
  const std::optional<Event> seen = WaitForEvent(
      [&](const Event& event) {
        return event.kind == Event::Kind::kHealth && event.subject == what && event.value >= level;
      },
      kDetectionPatience);
  EXPECT_TRUE(seen) << fault_ << ": no monitor said it of " << what;
  if (!seen) return false;
  const double after = SecondsSince(seen->stamp);
  EXPECT_LE(after, within) << fault_ << ": detected late by " << what;
  if (!detected_) {
    detected_by_ = what + (level < coppice_msgs::HealthEntry::ERROR ? " (warning)" : "");
    detected_ = after;
    limit_ = within;
  }
  return after <= within;
}

void FaultCase::SetDetected(const std::string& by, double within) {
  detected_by_ = by;
  detected_ = SecondsSince(rig_.Now());
  limit_ = within;
  EXPECT_LE(*detected_, within) << fault_ << ": detected late";
}

bool FaultCase::ExpectRestartBegun(const std::string& process, double within) {
  const std::optional<Event> begun = WaitForEvent(
      [&](const Event& event) {
        return event.kind == Event::Kind::kProcess && event.subject == process &&
               event.value == coppice_msgs::ProcessState::STARTING;
      },
      kDetectionPatience);
  EXPECT_TRUE(begun) << fault_ << ": " << process << " was not restarted";
  if (!begun) return false;
  EXPECT_LE(SecondsSince(begun->stamp), within) << fault_ << ": restarted late";
  if (!detected_) {
    detected_by_ = "end of " + process;
    detected_ = SecondsSince(begun->stamp);
    limit_ = within;
  }
  return SecondsSince(begun->stamp) <= within;
}

bool FaultCase::ExpectRestarted(const std::string& process, double patience) {
  const int before = pids_.count(process) > 0 ? pids_.at(process) : 0;
  const bool restarted = rig_.WaitFor(
      [&](const RobotState& state) {
        const int pid = state.ReadyPid(process);
        return pid != 0 && pid != before;
      },
      patience);
  EXPECT_TRUE(restarted) << fault_ << ": " << process << " was not restarted";
  AddRecovery("restart of " + process);
  return restarted;
}

bool FaultCase::ExpectAsked(const std::string& subject, double patience) {
  asked_ = rig_.WaitFor([&](const RobotState& state) { return state.IsAsked(subject); }, patience);
  EXPECT_TRUE(asked_) << fault_ << ": nobody was asked about " << subject;
  return asked_;
}

bool FaultCase::ExpectTold(const std::string& monitor, const std::string& subject,
                           double patience) {
  const std::string message = "tells: " + monitor + " " + subject + "\n";
  const bool told = rig_.WaitFor(
      [&](const RobotState&) {
        return rig_.Logged(kConsole).find(message, logged_) != std::string::npos;
      },
      patience);
  EXPECT_TRUE(told) << fault_ << ": nobody was told of " << monitor << " " << subject;
  AddRecovery("message");
  return told;
}

bool FaultCase::ExpectRecovery(const std::string& recovery, const std::string& subject, int phase,
                               double patience) {
  const std::optional<Event> seen = WaitForEvent(
      [&](const Event& event) {
        return event.kind == Event::Kind::kRecovery && event.value == phase &&
               event.subject == recovery + " of " + subject;
      },
      patience);
  EXPECT_TRUE(seen) << fault_ << ": no recovery \"" << recovery << "\" of " << subject
                    << " in phase " << phase;
  AddRecovery(recovery);
  return seen.has_value();
}

void FaultCase::AddRecovery(const std::string& recovery) {
  if (recovery_.find(recovery) != std::string::npos) return;
  recovery_ += (recovery_.empty() ? "" : ", ") + recovery;
}

bool FaultCase::ExpectAskedInTurn(const std::string& subject,
                                  const std::vector<std::string>& supervisors, double patience) {
  std::vector<std::string> asked;
  rig_.WaitFor(
      [&](const RobotState& state) {
        for (const coppice_msgs::HelpRequest& request : state.requests()) {
          if (request.subject == subject) asked = request.asked;
        }
        return asked.size() >= supervisors.size();
      },
      patience);
  EXPECT_EQ(asked, supervisors) << fault_;
  AddRecovery("asks one after the other");
  return asked == supervisors;
}

bool FaultCase::ExpectRequestEnded(const std::string& subject, int state, double patience) {
  const std::optional<Event> ended = WaitForEvent(
      [&](const Event& event) {
        return event.kind == Event::Kind::kRequest && event.subject == subject &&
               event.value == state;
      },
      patience);
  EXPECT_TRUE(ended) << fault_ << ": the request about " << subject << " did not end";
  return ended.has_value();
}

bool FaultCase::ExpectNominal(double patience) {
  const std::optional<Instant> since = rig_.WaitUntilNominal(patience);
  if (since) nominal_ = SecondsSince(*since);
  return since.has_value();
}

bool FaultCase::ExpectNominalWithin(double seconds) {
  if (!ExpectNominal()) return false;
  EXPECT_LE(*nominal_, seconds) << fault_ << ": nominal late";
  return *nominal_ <= seconds;
}

void FaultCase::ExpectOnlyRestarted(const std::set<std::string>& processes) {
  const std::map<std::string, int> now = Pids();
  for (const auto& [name, pid] : pids_) {
    const auto found = now.find(name);
    if (processes.count(name) > 0) continue;
    EXPECT_TRUE(found != now.end() && found->second == pid)
        << fault_ << ": " << name << " was disturbed";
  }
}

void FaultCase::ExpectNobodyAsked() {
  const bool asked = rig_.With([&](const RobotState& state) {
    for (const Event& event : state.events()) {
      if (event.kind == Event::Kind::kRequest && IsOfThis(event)) return true;
    }
    return false;
  });
  EXPECT_FALSE(asked) << fault_ << ": a person was asked";
}

}  // namespace coppice::robot
