// What others may ask of the supervisor.
#include <algorithm>

#include "robot_app/processes/supervisor.h"

namespace coppice::robot::processes {

std::optional<std::size_t> Supervisor::Find(const std::string& name) const {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    const ProcessConfig& process = config_.processes[i];
    if (process.name == name || (!name.empty() && process.node == name)) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> Supervisor::FindGroup(const std::string& name) const {
  for (std::size_t i = 0; i < config_.groups.size(); ++i) {
    if (config_.groups[i].name == name) return i;
  }
  return std::nullopt;
}

Problem Supervisor::Unknown(const std::string& name) const {
  std::vector<std::string> names;
  for (const ProcessConfig& process : config_.processes) {
    names.push_back(process.name);
    if (!process.node.empty()) names.push_back(process.node);
  }
  for (const GroupConfig& group : config_.groups) names.push_back(group.name);
  return {"no process, node or group \"" + name + "\" " + DidYouMean(name, names)};
}

Expected<std::string> Supervisor::SetConfiguration(const std::string& name, Hand hand,
                                                   const CheckCondition& check) {
  if (stopping_) return Problem{"the supervisor is stopping"};
  ++revision_;
  return switch_.Request(name, hand, check);
}

Expected<std::string> Supervisor::SetSite(const std::string& name, Hand hand,
                                          const CheckSite& check) {
  std::vector<std::string> names;
  for (const SiteConfig& site : config_.sites) names.push_back(site.name);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return Problem{"no site \"" + name + "\" " + DidYouMean(name, names)};
  }
  if (stopping_) return Problem{"the supervisor is stopping"};
  if (name == site_) return "the robot is at " + name + " already";
  if (new_stack_) return Problem{"the whole stack is being restarted"};
  if (switch_.safe_stop()) {
    return Problem{"the robot is in a safe stop until what was given up is reset"};
  }
  if (hand == Hand::kTree && switch_.manual()) {
    return Problem{"configuration " + configuration() + " is held by hand until it is released"};
  }
  if (const Outcome complete = check(name); !complete) return Problem{complete.problem()};
  site_ = name;
  RestartStack("the robot was brought to " + name, false);
  return "all begins anew at " + name;
}

std::string Supervisor::Release() {
  ++revision_;
  return switch_.Release();
}

Expected<std::string> Supervisor::SafeStop() {
  if (stopping_) return Problem{"the supervisor is stopping"};
  if (!config_.given_up.configuration) return Problem{"no configuration is for the safe stop"};
  switch_.SafeStop();
  ++revision_;
  return "safe stop";
}

Expected<std::string> Supervisor::Restart(const std::string& name, Time now, bool cleared) {
  if (stopping_) return Problem{"the supervisor is stopping"};
  if (new_stack_) return "the whole stack is being restarted";
  if (name == "all") {
    escalation_.stack().Add(now);
    RestartStack("restarted on request", cleared);
    return "the whole stack is restarted";
  }
  const auto group = FindGroup(name);
  const auto process = Find(name);
  if (!process && !group) return Unknown(name);
  const Indices members = process ? Indices{*process} : config_.groups[*group].processes;
  const auto wanted = std::find_if(members.begin(), members.end(),
                                   [this](std::size_t member) { return IsWanted(member); });
  if (wanted == members.end()) {
    return Problem{name + " is not part of configuration " + configuration()};
  }
  if (const auto given_up = GivenUpAbove(*wanted)) {
    return Problem{name + " needs a reset: " + config_.groups[*given_up].name +
                   " is given up: " + escalation_.given_up(*given_up)};
  }
  return RestartWanted(*wanted, members, name, now, cleared);
}

// `process`: the one that counts. `members`: all that were asked for.
Expected<std::string> Supervisor::RestartWanted(std::size_t process, const Indices& members,
                                                const std::string& name, Time now, bool cleared) {
  Plan& plan = plans_[process];
  const bool is_down = !lifecycle_.IsUp(process) && !plan.done;
  if (is_down || plan.as_restart || AwaitsReadiness(process)) {
    if (!AwaitsReadiness(process)) plan.cleared = plan.cleared || cleared;
    return name + " is about to start already";
  }
  plan.done = false;
  const Decision decision = Fail(process, Cause::kRequest, "restarted on request", now);
  if (decision.refused) {
    return Problem{name + " needs a person: restarts have not helped, " + decision.reason};
  }
  if (decision.step == EscalationStep::kClosure) {
    return name + " is restarted with all that depends on " + config_.groups[decision.root].name;
  }
  plan.cleared = cleared;
  if (members.size() > 1) {
    BeginWave(members, {"restarted on request", plan.not_before, cleared}, now);
  }
  return name + " is restarted";
}

Expected<std::string> Supervisor::Reset(const std::string& name, Time now) {
  std::vector<std::size_t> groups;
  if (name == "all") {
    for (std::size_t i = 0; i < config_.groups.size(); ++i) groups.push_back(i);
  } else if (const auto group = FindGroup(name)) {
    groups.push_back(*group);
  } else if (const auto process = Find(name)) {
    groups.push_back(config_.processes[*process].group);
  } else {
    return Unknown(name);
  }
  for (const std::size_t group : groups) {
    escalation_.Reset(group);
    for (const std::size_t member : config_.groups[group].processes) {
      Plan& plan = plans_[member];
      plan.done = false;
      plan.not_before = now;
    }
  }
  if (!escalation_.AnyGivenUp()) switch_.EndSafeStop();
  ++revision_;
  return "restarts of " + name + " are forgotten";
}

}  // namespace coppice::robot::processes
