#include "robot_app/processes/escalation.h"

#include <algorithm>
#include <utility>

namespace coppice::robot::processes {
namespace {

RestartLimits StackLimits(const EscalationLimits& escalation) {
  RestartLimits limits;
  limits.restarts = escalation.stack;
  limits.hourly = 3 * escalation.stack;
  return limits;
}

}  // namespace

const char* ToString(EscalationStep step) {
  switch (step) {
    case EscalationStep::kGroup:
      return "group";
    case EscalationStep::kClosure:
      return "closure";
    case EscalationStep::kStack:
      return "stack";
    case EscalationStep::kPerson:
      return "person";
  }
  return "?";
}

Escalation::Escalation(const RobotConfig& config, const GroupOrder& order)
    : config_(config), order_(order), stack_(StackLimits(config.escalation)) {
  for (const GroupConfig& group : config.groups) groups_.emplace_back(group.limits);
}

Decision Escalation::OnFailure(std::size_t group, Cause cause, Time now) {
  Group& failed = groups_[group];
  if (!failed.trouble_since) failed.trouble_since = now;
  if (IsOverdue(group, now)) {
    return Climb(group, cause, "in trouble for " + SecondsText(now - *failed.trouble_since), now);
  }
  if (failed.step != EscalationStep::kGroup) {
    return Climb(group, cause,
                 std::string("failed again after a restart of the ") + ToString(failed.step), now);
  }
  const Outcome allowed = failed.budget.Check(now);
  if (!allowed) return Climb(group, cause, allowed.problem(), now);
  Decision decision;
  decision.root = group;
  decision.delay = failed.budget.Delay(config_.back_off, now);
  failed.budget.Add(now);
  return decision;
}

// Dependencies come first in the order.
std::size_t Escalation::RootOf(std::size_t group) const {
  for (const std::size_t above : order_.upstream(group)) {
    if (groups_[above].trouble_since) return above;
  }
  return group;
}

Decision Escalation::Climb(std::size_t group, Cause cause, std::string reason, Time now) {
  Decision decision;
  decision.root = RootOf(group);
  decision.reason = std::move(reason);
  const Group &root = groups_[decision.root], &failed = groups_[group];
  const bool late = IsOverdue(group, now) || IsOverdue(decision.root, now);
  const int closures = std::max(root.closures, failed.closures);
  const bool stack_had_its_turn = std::max(root.step, failed.step) >= EscalationStep::kStack;
  const bool essential = config_.groups[decision.root].essential || config_.groups[group].essential;
  if (!late && !stack_had_its_turn && closures < config_.escalation.closure) {
    decision.step = EscalationStep::kClosure;
  } else if (cause == Cause::kRequest) {
    decision.refused = true;
    return decision;
  } else if (!late && essential && stack_.Check(now)) {
    decision.step = EscalationStep::kStack;
    stack_.Add(now);
  } else {
    decision.step = EscalationStep::kPerson;
    return decision;
  }
  for (const std::size_t member : order_.closure(decision.root)) {
    Group& affected = groups_[member];
    if (!affected.trouble_since) continue;
    affected.step = decision.step;
    if (decision.step == EscalationStep::kClosure) affected.closures = closures + 1;
  }
  return decision;
}

void Escalation::SetReady(std::size_t group, bool ready, Time now) {
  Group& state = groups_[group];
  state.budget.SetReady(ready, now);
  if (!ready || IsGivenUp(group) || !state.budget.IsHealthy(now)) return;
  if (!state.budget.Check(now)) return;  // healthy again, but too often
  state.step = EscalationStep::kGroup;
  state.closures = 0;
  state.trouble_since.reset();
}

void Escalation::Excuse(std::size_t group, Time now) {
  if (groups_[group].trouble_since) groups_[group].trouble_since = now;
}

bool Escalation::IsOverdue(std::size_t group, Time now) const {
  const Group& state = groups_[group];
  return state.trouble_since && now - *state.trouble_since >= config_.escalation.ask_within;
}

void Escalation::GiveUp(std::size_t group, std::string reason) {
  groups_[group].step = EscalationStep::kPerson;
  groups_[group].given_up = std::move(reason);
}

void Escalation::Reset(std::size_t group) {
  for (const std::size_t member : order_.closure(group)) {
    if (member != group && IsGivenUp(member)) continue;
    groups_[member] = Group(config_.groups[member].limits);
  }
}

bool Escalation::AnyGivenUp() const {
  return std::any_of(groups_.begin(), groups_.end(),
                     [](const Group& group) { return group.step == EscalationStep::kPerson; });
}

GroupMemory Escalation::Remember(std::size_t group) const {
  const Group& state = groups_[group];
  return {state.budget.times(), state.budget.counting(), state.step,
          state.closures,       state.trouble_since,     state.given_up};
}

void Escalation::Restore(std::size_t group, const GroupMemory& memory) {
  Group& state = groups_[group];
  state.budget.Restore(memory.restarts, memory.counting);
  state.step = memory.step;
  state.closures = memory.closures;
  state.trouble_since = memory.trouble_since;
  state.given_up = memory.given_up;
}

}  // namespace coppice::robot::processes
