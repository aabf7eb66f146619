#include "robot_app/deployment/robot/helpers.h"

#include <utility>

namespace coppice::robot::deployment {
namespace {

using assistance::HelpRequest;
using assistance::HelpState;
using assistance::Letter;

}  // namespace

Helpers::Helpers(World& world, std::vector<assistance::HumanSupervisor> people,
                 assistance::HelpDesk::RulesOf rules)
    : world_(world), desk_(std::move(people), std::move(rules)), chance_(world.seed, "people") {}

void Helpers::Ask(const std::string& subject, const std::string& question,
                  Sender<leaves::ActionResult> done) {
  const Expected<std::uint32_t> id = desk_.Ask(subject, question, world_.now());
  if (!id) return done.Send({false, id.problem()});
  const auto known = waiting_.find(*id);
  if (known != waiting_.end()) {
    known->second.done = done;
    return;
  }
  waiting_[*id] = {subject, done, world_.journal.requests.size()};
  world_.journal.requests.push_back({subject, world_.now(), kNever, false, "open"});
  ++open_;
}

void Helpers::Withdraw(const std::string& subject) {
  desk_.Withdraw(subject, world_.now());
  for (auto it = waiting_.begin(); it != waiting_.end(); ++it) {
    if (it->second.subject == subject) it->second.done = {};
  }
}

void Helpers::Tell(const std::string& subject, const std::string& message) {
  desk_.Tell(subject, message);
}

void Helpers::Step(bool is_up) {
  if (!is_up) return;
  desk_.Step(world_.now());
  for (const Letter& letter : desk_.TakeLetters(world_.now())) {
    desk_.Delivered(letter.number, world_.network, world_.now());
    if (world_.network && letter.kind == Letter::Kind::kQuestion) Deliver(letter);
  }
  TakeOutcomes();
}

// Nobody works before the morning, nor at the weekend.
Time Helpers::Awake(Time when) const {
  for (int day = 0; day < 10; ++day) {
    const Interval today = DayAt(when + std::chrono::hours(24) * day);
    const Time from = today.from + Seconds(world_.scenario.operator_from * 3600);
    const Time to = today.from + Seconds(world_.scenario.operator_to * 3600);
    if (WeekendSeconds(today) > 0) continue;
    if (when < to) return std::max(when, from);
  }
  return when;
}

double Helpers::TimeToAct(double median) {
  const Time when = Awake(world_.now());
  const double seconds = chance_.LogNormal(median, world_.scenario.answer_sigma);
  return SecondsOf({world_.now(), when}) + seconds;
}

void Helpers::Deliver(const Letter& letter) {
  const double answers = TimeToAct(world_.scenario.answer_median);
  const double service =
      chance_.Uniform(world_.scenario.service_shortest, world_.scenario.service_longest);
  const bool never = chance_.Happens(world_.scenario.answer_never);
  if (never) return;
  const std::string by = desk_.supervisors()[letter.supervisor].name;
  world_.After(answers + service, [this, id = letter.request, by] { Answer(id, by); });
}

void Helpers::Answer(std::uint32_t id, const std::string& by) {
  const HelpRequest* const request = desk_.Find(id);
  if (!request || request->state != HelpState::kOpen) return;
  if (on_help) on_help(request->subject);
  (void)desk_.Answer(id, by, true, world_.now());
  TakeOutcomes();
}

void Helpers::TakeOutcomes() {
  for (auto it = waiting_.begin(); it != waiting_.end();) {
    const HelpRequest* const request = desk_.Find(it->first);
    if (request && request->state == HelpState::kOpen) {
      ++it;
      continue;
    }
    const bool is_fixed = request && request->state == HelpState::kFixed;
    Close(it->second, is_fixed, request ? request->message : "forgotten");
    it->second.done.Send({request && request->ok, request ? request->message : ""});
    it = waiting_.erase(it);
    --open_;
  }
}

void Helpers::Close(const Waiting& waiting, bool is_fixed, const std::string& outcome) {
  Request& entry = world_.journal.requests[waiting.entry];
  entry.closed = world_.now();
  entry.is_fixed = is_fixed;
  entry.outcome = outcome;
}

}  // namespace coppice::robot::deployment
