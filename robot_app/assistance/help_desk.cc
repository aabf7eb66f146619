#include "robot_app/assistance/help_desk.h"

#include <algorithm>
#include <utility>

#include "bt_core/frames/tick_coding.h"

namespace coppice::robot::assistance {
namespace {

using State = AskedSupervisor::State;

AskedSupervisor* FindAsked(HelpRequest& request, const std::string& name) {
  const auto found = std::find_if(request.asked.begin(), request.asked.end(),
                                  [&](const AskedSupervisor& asked) { return asked.name == name; });
  return found == request.asked.end() ? nullptr : &*found;
}

std::string Subject(const std::string& text) { return CutText(text, HelpDesk::kLongestSubject); }
std::string Text(const std::string& text) { return CutText(text, HelpDesk::kLongestText); }

bool HaveAllDeclined(const HelpRequest& request) {
  return std::all_of(request.asked.begin(), request.asked.end(), [](const AskedSupervisor& asked) {
    return asked.state == State::kDeclined || asked.state == State::kUnreachable;
  });
}

}  // namespace

HelpDesk::HelpDesk(std::vector<HumanSupervisor> supervisors, RulesOf rules, std::uint32_t first_id)
    : supervisors_(std::move(supervisors)),
      rules_(std::move(rules)),
      letters_(supervisors_),
      next_id_(first_id) {}

Expected<std::uint32_t> HelpDesk::Ask(const std::string& about, const std::string& asked, Time now,
                                      Duration deadline) {
  const std::string subject = Subject(about);
  const std::string question = Text(asked);
  if (HelpRequest* const open = FindOpen(subject)) {
    if (open->question != question || open->withdrawn_at != kNever) ++version_;
    open->question = question;
    open->withdrawn_at = kNever;
    return open->id;
  }
  if (OpenRequests() >= kMostOpen) {
    return Problem{"\"" + subject + "\" is not asked: " + std::to_string(kMostOpen) +
                   " requests are open already"};
  }
  HelpRequest request;
  request.id = next_id_++;
  request.subject = subject;
  request.question = question;
  request.opened = now;
  request.deadline = now + (deadline > Duration::zero() ? deadline : rules_(subject).deadline);
  request.remind_at = now + rules_(subject).remind;
  requests_.push_back(std::move(request));
  AskNext(requests_.back(), now);
  ForgetOldest();
  return next_id_ - 1;
}

bool HelpDesk::Withdraw(const std::string& subject, Time now) {
  HelpRequest* const open = FindOpen(Subject(subject));
  if (!open) return false;
  if (open->withdrawn_at == kNever) open->withdrawn_at = now;
  ++version_;
  return true;
}

void HelpDesk::Tell(const std::string& subject, const std::string& message) {
  if (supervisors_.empty()) return;
  Letter letter;
  letter.subject = Subject(subject);
  letter.text = Text(message);
  letters_.Add(std::move(letter));
}

void HelpDesk::Take(std::uint32_t id, const std::string& by, Time now) {
  HelpRequest* const open = FindOpen(id);
  if (!open) return;
  open->taken_by = by;
  open->ask_next_at = now + rules_(open->subject).next;
  open->remind_at = now + rules_(open->subject).remind;
  ++version_;
}

Expected<std::string> HelpDesk::Answer(std::uint32_t id, const std::string& by, bool fixed,
                                       Time now) {
  HelpRequest* const open = FindOpen(id);
  if (open && fixed) {
    Close(*open, HelpState::kFixed, by, by + " has fixed it.");
    return "Thank you. The others have been told.";
  }
  if (open) return Decline(*open, by, now);
  const HelpRequest* const closed = Find(id);
  return Problem{closed ? "It was closed before: " + closed->message : "There is no such request."};
}

std::string HelpDesk::Decline(HelpRequest& request, const std::string& by, Time now) {
  if (AskedSupervisor* const asked = FindAsked(request, by)) asked->state = State::kDeclined;
  ++version_;
  if (AskNext(request, now)) return "Thank you. The next supervisor is asked.";
  if (!HaveAllDeclined(request)) return "Thank you. The robot waits for the others.";
  Close(request, HelpState::kNotFixed, by, "Nobody who was asked could fix it.");
  return "Thank you. Nobody else is left to ask.";
}

void HelpDesk::Step(Time now) {
  for (HelpRequest& request : requests_) {
    if (request.state != HelpState::kOpen) continue;
    const HelpRules rules = rules_(request.subject);
    if (request.withdrawn_at != kNever) {
      if (now < request.withdrawn_at + rules.settle) continue;
      Close(request, HelpState::kWithdrawn, "", "It has settled itself.");
    } else if (now >= request.deadline) {
      Close(request, HelpState::kNobody, "", "Nobody answered in time. " + rules.when_nobody);
    } else if (now >= request.ask_next_at && AskNext(request, now)) {
      continue;
    } else if (now >= request.remind_at) {
      Remind(request, now);
    }
  }
}

void HelpDesk::Delivered(std::uint32_t number, bool ok, Time now) {
  const LetterQueue::Report report = letters_.Delivered(number, ok, now);
  const Letter& letter = report.letter;
  if (report.progress == LetterQueue::Progress::kUnknown ||
      report.progress == LetterQueue::Progress::kTryingNextWay) {
    return;
  }
  const bool reached = report.progress == LetterQueue::Progress::kDelivered;
  if (!reached && letter.kind == Letter::Kind::kNotice &&
      letter.supervisor + 1 < supervisors_.size()) {
    Letter to_next = letter;
    ++to_next.supervisor;
    letters_.Drop(letter.number);
    letters_.Add(std::move(to_next));
    return;
  }
  HelpRequest* const request = letter.request == 0 ? nullptr : FindOpen(letter.request);
  if (!request) return;
  AskedSupervisor* const asked = FindAsked(*request, supervisors_[letter.supervisor].name);
  if (!asked || asked->state == State::kDeclined) return;
  const bool is_first_failure = !reached && asked->state != State::kUnreachable;
  asked->state = reached ? State::kReached : State::kUnreachable;
  ++version_;
  if (is_first_failure) AskNext(*request, now);
}

const HelpRequest* HelpDesk::Find(std::uint32_t id) const {
  const auto found = std::find_if(requests_.begin(), requests_.end(),
                                  [id](const HelpRequest& request) { return request.id == id; });
  return found == requests_.end() ? nullptr : &*found;
}

void HelpDesk::Restore(std::vector<HelpRequest> requests) {
  for (HelpRequest& request : requests) {
    next_id_ = std::max(next_id_, request.id + 1);
    requests_.push_back(std::move(request));
    const HelpRequest& kept = requests_.back();
    for (const AskedSupervisor& asked : kept.asked) {
      if (kept.state != HelpState::kOpen || asked.state == State::kReached) continue;
      if (asked.state == State::kDeclined) continue;
      Send(Letter::Kind::kQuestion, kept, asked.name, kept.question);
    }
  }
  ++version_;
}

std::size_t HelpDesk::OpenRequests() const {
  return static_cast<std::size_t>(
      std::count_if(requests_.begin(), requests_.end(),
                    [](const HelpRequest& request) { return request.state == HelpState::kOpen; }));
}

HelpRequest* HelpDesk::FindOpen(const std::string& subject) {
  for (HelpRequest& request : requests_) {
    if (request.state == HelpState::kOpen && request.subject == subject) return &request;
  }
  return nullptr;
}

HelpRequest* HelpDesk::FindOpen(std::uint32_t id) {
  for (HelpRequest& request : requests_) {
    if (request.state == HelpState::kOpen && (id == 0 || request.id == id)) return &request;
  }
  return nullptr;
}

// False if everybody was asked.
bool HelpDesk::AskNext(HelpRequest& request, Time now) {
  const auto next = std::find_if(
      supervisors_.begin(), supervisors_.end(),
      [&](const HumanSupervisor& candidate) { return !FindAsked(request, candidate.name); });
  request.ask_next_at = now + rules_(request.subject).next;
  ++version_;
  if (next == supervisors_.end()) return false;
  request.remind_at = now + rules_(request.subject).remind;
  request.asked.push_back({next->name, State::kPending});
  Send(Letter::Kind::kQuestion, request, next->name, request.question);
  return true;
}

void HelpDesk::Send(Letter::Kind kind, const HelpRequest& request, const std::string& to,
                    const std::string& text) {
  for (std::size_t i = 0; i < supervisors_.size(); ++i) {
    if (supervisors_[i].name != to) continue;
    Letter letter;
    letter.kind = kind;
    letter.request = request.id;
    letter.supervisor = i;
    letter.subject = request.subject;
    letter.text = text;
    letters_.Add(std::move(letter));
  }
}

// To whom no letter has gone out yet, one is still on its way.
void HelpDesk::Remind(HelpRequest& request, Time now) {
  request.remind_at = now + rules_(request.subject).remind;
  for (const AskedSupervisor& asked : request.asked) {
    if (asked.state != State::kReached) continue;
    Send(Letter::Kind::kReminder, request, asked.name, request.question);
  }
}

void HelpDesk::Close(HelpRequest& request, HelpState state, const std::string& by,
                     std::string message) {
  request.state = state;
  request.answered_by = by;
  request.ok = state == HelpState::kFixed || state == HelpState::kWithdrawn ||
               (state == HelpState::kNobody && rules_(request.subject).ok_when_nobody);
  request.message = std::move(message);
  letters_.DropIf([&](const Letter& letter) { return letter.request == request.id; });
  for (const AskedSupervisor& asked : request.asked) {
    if (asked.name == by || asked.state == State::kUnreachable) continue;
    Send(Letter::Kind::kAllClear, request, asked.name, request.message);
  }
  ++version_;
}

void HelpDesk::ForgetOldest() {
  const auto is_closed = [](const HelpRequest& request) {
    return request.state != HelpState::kOpen;
  };
  for (std::size_t kept = requests_.size() - OpenRequests(); kept > kClosedKept; --kept) {
    requests_.erase(std::find_if(requests_.begin(), requests_.end(), is_closed));
  }
}

}  // namespace coppice::robot::assistance
