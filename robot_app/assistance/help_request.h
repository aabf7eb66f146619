// A question to the robot's human supervisors, and what is said about it to whom. Values only.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_HELP_REQUEST_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_HELP_REQUEST_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"

namespace coppice::robot::assistance {

/// One way to reach a person: a channel of the configuration, and the address there.
struct Way {
  std::string channel;
  std::string to;
};

/// Somebody who looks after the robot. The ways are tried in this order.
struct HumanSupervisor {
  std::string name;
  std::vector<Way> ways;
};

/// How patient the robot is with a question about a subject.
struct HelpRules {
  Duration remind = std::chrono::minutes(2);     ///< between reminders to those who were asked
  Duration next = std::chrono::minutes(5);       ///< until the next supervisor is asked as well
  Duration deadline = std::chrono::minutes(30);  ///< until nobody is waited for any more
  /// How long a fault must have gone before people hear of it; if it comes back, they never do.
  Duration settle = std::chrono::seconds(10);
  bool ok_when_nobody = false;  ///< the answer that counts if nobody gives one
  std::string when_nobody = "The robot stays where it is.";  ///< what then happens, for people
};

enum class HelpState : std::uint8_t { kOpen, kFixed, kNotFixed, kWithdrawn, kNobody };

/// One supervisor in one request.
struct AskedSupervisor {
  enum class State : std::uint8_t { kPending, kReached, kUnreachable, kDeclined };
  std::string name;
  State state = State::kPending;
};

struct HelpRequest {
  std::uint32_t id = 0;
  std::string subject;
  std::string question;
  HelpState state = HelpState::kOpen;
  Time opened{};
  Time deadline{};
  Time ask_next_at{};
  Time remind_at{};
  Time withdrawn_at = kNever;  ///< of an open one: closes when that has settled
  std::vector<AskedSupervisor> asked;
  std::string taken_by;     ///< the last one who opened the page for it
  std::string answered_by;  ///< of a closed one
  bool ok = false;          ///< of a closed one: whether to go on as if it was fixed
  std::string message;      ///< of a closed one, for people
};

/// Something to be sent to one supervisor.
struct Letter {
  enum class Kind : std::uint8_t { kQuestion, kReminder, kAllClear, kNotice };
  std::uint32_t number = 0;
  Kind kind = Kind::kNotice;
  std::uint32_t request = 0;   ///< 0: belongs to none
  std::size_t supervisor = 0;  ///< index
  std::size_t way = 0;         ///< index into the ways of the supervisor
  std::string subject;
  std::string text;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_HELP_REQUEST_H_
