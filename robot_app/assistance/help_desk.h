// Decides whom the robot asks for help, when it reminds them, when it asks the next one, and whose
// answer counts: many questions by subject, a list of supervisors in an order, the first answer
// wins, the others get an all-clear. Every question ends, at the latest at its deadline.
//
//   HelpDesk desk(supervisors, rules_of_subject, first_id);
//   desk.Ask("navigation", "The way is blocked.", now);
//   for (const Letter& letter : desk.TakeLetters(now)) ...;   // send, then desk.Delivered(...)
//   desk.Answer(id, "Ada", true, now);
//
// Knows no sockets, no ROS and no clock: time is handed in, in nanoseconds of a clock that never
// goes back. Not for several threads.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_HELP_DESK_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_HELP_DESK_H_

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/assistance/channels/letter_queue.h"
#include "robot_app/assistance/help_request.h"

namespace coppice::robot::assistance {

class HelpDesk {
 public:
  static constexpr std::size_t kClosedKept = 20;
  static constexpr std::size_t kMostOpen = 32;  ///< people can look after no more
  /// What is longer is cut [bytes]
  static constexpr std::size_t kLongestSubject = 200, kLongestText = 4000;

  using RulesOf = std::function<HelpRules(const std::string& subject)>;

  /// Ids grow from `first_id`, so that those of an earlier run need not come again.
  HelpDesk(std::vector<HumanSupervisor> supervisors, RulesOf rules, std::uint32_t first_id = 1);
  HelpDesk(const HelpDesk&) = delete;
  HelpDesk& operator=(const HelpDesk&) = delete;

  /// Opens a question, or joins the open one of the subject: nobody is asked twice, and what is
  /// said from now on is the newer text. `deadline` 0: that of the rules. Returns the id; a problem
  /// if too many questions are open and none is of the subject.
  Expected<std::uint32_t> Ask(const std::string& subject, const std::string& question, Time now,
                              Duration deadline = Duration::zero());

  /// The fault has gone. Once that has settled, the question closes and those who were asked hear
  /// of it; asked again before, it just goes on. False if nothing was open.
  bool Withdraw(const std::string& subject, Time now);

  /// A message that asks nothing, to the first supervisor who can be reached. Of very many that
  /// reach nobody the oldest are forgotten.
  void Tell(const std::string& subject, const std::string& message);

  /// Somebody has opened the page for it: the next supervisor is not asked yet.
  void Take(std::uint32_t id, const std::string& by, Time now);

  /// The first one to say "fixed" closes the question. "Not fixed" passes it to the next
  /// supervisor, and closes it if everybody who was asked has said so and nobody is left. id 0: the
  /// oldest open. Returns what the one who answered is told.
  Expected<std::string> Answer(std::uint32_t id, const std::string& by, bool fixed, Time now);

  /// Reminders, next supervisors, deadlines. Call it several times a second.
  void Step(Time now);

  /// What is to be sent now; report each letter to Delivered.
  std::vector<Letter> TakeLetters(Time now) { return letters_.TakeDue(now); }
  void Delivered(std::uint32_t letter, bool ok, Time now);

  const std::vector<HumanSupervisor>& supervisors() const { return supervisors_; }
  /// Open and lately closed ones, the oldest first.
  const std::deque<HelpRequest>& requests() const { return requests_; }
  const HelpRequest* Find(std::uint32_t id) const;
  /// Grows with every change of a request.
  std::uint64_t version() const { return version_; }

  /// Takes up the open requests of an earlier run: who was not reached yet is asked now.
  void Restore(std::vector<HelpRequest> requests);

 private:
  std::size_t OpenRequests() const;
  HelpRequest* FindOpen(const std::string& subject);
  HelpRequest* FindOpen(std::uint32_t id);
  bool AskNext(HelpRequest& request, Time now);
  void Send(Letter::Kind kind, const HelpRequest& request, const std::string& to,
            const std::string& text);
  void Remind(HelpRequest& request, Time now);
  void Close(HelpRequest& request, HelpState state, const std::string& by, std::string message);
  std::string Decline(HelpRequest& request, const std::string& by, Time now);
  void ForgetOldest();

  const std::vector<HumanSupervisor> supervisors_;
  const RulesOf rules_;
  LetterQueue letters_;
  std::deque<HelpRequest> requests_;
  std::uint32_t next_id_;
  std::uint64_t version_ = 0;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_HELP_DESK_H_
