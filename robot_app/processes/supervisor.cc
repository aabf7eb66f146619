#include "robot_app/processes/supervisor.h"

#include <sys/wait.h>

#include <algorithm>
#include <utility>

namespace coppice::robot::processes {
namespace {

// How a transport to another host says that it got no connection (ssh(1)); coppice-remote never
// ends like that.
constexpr int kNoConnection = 255;

constexpr Duration kHostRetry = std::chrono::seconds(5);

// Steps are some tens of milliseconds apart. After a longer pause it was the supervisor that stood
// still, and what the others have said meanwhile has yet to be read.
constexpr Duration kOwnPause = std::chrono::seconds(1);

std::string DescribeEnd(int wait_status) {
  if (WIFSIGNALED(wait_status)) {
    return "ended by signal " + std::to_string(WTERMSIG(wait_status));
  }
  return "ended with exit status " + std::to_string(WEXITSTATUS(wait_status));
}

bool EndedWith(int wait_status, int status) {
  return WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == status;
}

}  // namespace

Supervisor::Supervisor(RobotConfig config, ProcessLauncher& launcher,
                       const SupervisorMemory& memory)
    : config_(std::move(config)),
      order_(config_),
      lifecycle_(config_, launcher),
      escalation_(config_, order_),
      switch_(config_),
      plans_(config_.processes.size()) {
  if (!config_.sites.empty()) site_ = config_.sites[config_.site].name;
  for (std::size_t i = 0; i < config_.configurations.size(); ++i) {
    if (config_.configurations[i].name == memory.configuration) {
      switch_.Restore(i, memory.manual, memory.safe_stop);
    }
  }
  for (std::size_t i = 0; i < config_.groups.size(); ++i) {
    const auto found = memory.groups.find(config_.groups[i].name);
    if (found != memory.groups.end()) escalation_.Restore(i, found->second);
  }
  for (std::size_t i = 0; i < config_.processes.size(); ++i) {
    const auto found = memory.restarts.find(config_.processes[i].name);
    if (found != memory.restarts.end()) lifecycle_.SetRestarts(i, found->second);
    plans_[i].as_restart = memory.new_stack;
    plans_[i].cleared = memory.clear_stack;
  }
  escalation_.stack().Restore(memory.stack_restarts, memory.stack_counting);
}

SupervisorMemory Supervisor::RememberAt(const std::string& site) const {
  SupervisorMemory memory;
  memory.site = site;
  const bool is_other = !config_.sites.empty() && site != config_.sites[config_.site].name;
  if (!is_other) {  // else it begins with that of the new one
    memory.configuration = config_.configurations[switch_.before_safe_stop()].name;
    memory.manual = switch_.manual();
    memory.safe_stop = switch_.safe_stop();
    memory.new_stack = new_stack_;
    memory.clear_stack = clear_stack_;
  }
  for (std::size_t i = 0; i < config_.groups.size(); ++i) {
    memory.groups[config_.groups[i].name] = escalation_.Remember(i);
  }
  for (std::size_t i = 0; i < config_.processes.size(); ++i) {
    memory.restarts[config_.processes[i].name] = status(i).restarts;
  }
  memory.stack_restarts = escalation_.stack().times();
  memory.stack_counting = escalation_.stack().counting();
  return memory;
}

std::vector<std::string> Supervisor::TakeCalls() { return std::exchange(calls_, {}); }

EscalationStep Supervisor::escalation(std::size_t process) const {
  return escalation_.step(config_.processes[process].group);
}

int Supervisor::RestartsUsed(std::size_t process, Time now) {
  return escalation_.RestartsUsed(config_.processes[process].group, now);
}

// ---- what should be

bool Supervisor::IsWanted(std::size_t process) const {
  return !stopping_ && !new_stack_ &&
         Contains(config_.configurations[switch_.current()].processes, process);
}

std::optional<std::size_t> Supervisor::GivenUpAbove(std::size_t process) const {
  for (const std::size_t group : order_.upstream(config_.processes[process].group)) {
    if (escalation_.IsGivenUp(group)) return group;
  }
  return std::nullopt;
}

bool Supervisor::MustEnd(std::size_t process) const {
  return lifecycle_.IsUp(process) &&
         (!IsWanted(process) || plans_[process].end_first || GivenUpAbove(process));
}

// Those that stay up must do without it, or they would depend on it.
bool Supervisor::DependentsEnd(std::size_t process, Time now) const {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (i == process || !MustEnd(i) || lifecycle_.IsStuck(i, now)) continue;
    if (Contains(order_.needs(i), process)) return true;
    if (Contains(config_.processes[i].after, process)) return true;
  }
  return false;
}

// Ready, or done with its work.
bool Supervisor::IsSatisfied(std::size_t process) const {
  return status(process).phase == ProcessPhase::kReady || plans_[process].done;
}

std::optional<std::size_t> Supervisor::MissingNeed(std::size_t process) const {
  for (const std::size_t needed : order_.needs(process)) {
    if (IsWanted(needed) && !IsSatisfied(needed)) return needed;
  }
  return std::nullopt;
}

std::optional<std::size_t> Supervisor::MissingDependency(std::size_t process) const {
  if (const auto needed = MissingNeed(process)) return needed;
  for (const std::size_t earlier : config_.processes[process].after) {
    const ProcessPhase phase = status(earlier).phase;
    const bool to_come = phase == ProcessPhase::kStarting || phase == ProcessPhase::kStopped;
    if (IsWanted(earlier) && to_come && !plans_[earlier].done && !GivenUpAbove(earlier)) {
      return earlier;
    }
  }
  return std::nullopt;
}

// First what ends, then what starts: what is not wanted any more, and the others of its wave.
bool Supervisor::IsEndingFirst(std::size_t process, Time now) const {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (!MustEnd(i) || lifecycle_.IsStuck(i, now)) continue;
    const bool same_wave = plans_[i].wave != 0 && plans_[i].wave == plans_[process].wave;
    if (!IsWanted(i) || same_wave) return true;
  }
  return false;
}

bool Supervisor::IsChanging() const {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    const bool should_run = IsWanted(i) && !plans_[i].done && !GivenUpAbove(i);
    if (should_run ? status(i).phase != ProcessPhase::kReady : lifecycle_.IsUp(i)) return true;
  }
  return false;
}

// ---- events

void Supervisor::OnExit(int pid, int wait_status, Time now) {
  const auto ended = lifecycle_.OnExit(pid);
  if (!ended) return;
  const std::size_t process = ended->process;
  Plan& plan = plans_[process];
  const bool expected = ended->asked || plan.end_first;
  plan.end_first = false;
  if (expected) return;
  lifecycle_.SetPhase(process, ProcessPhase::kStopped, DescribeEnd(wait_status), now);
  const ProcessConfig& config = config_.processes[process];
  if (config.host && (!ended->connected || EndedWith(wait_status, kNoConnection))) {
    LoseHost(process, now);
  } else if (config.restart == RestartRule::kNever ||
             (config.restart == RestartRule::kOnFailure && EndedWith(wait_status, 0))) {
    plan.done = true;
  } else {
    Fail(process, Cause::kEnd, DescribeEnd(wait_status), now);
  }
}

void Supervisor::OnReady(std::size_t process, int pid, Time now) {
  if (!AwaitsReadiness(process) || status(process).pid != pid) return;
  lifecycle_.SetPhase(process, ProcessPhase::kReady, "", now);
}

void Supervisor::OnMasterEnded(Time now, const std::string& what) {
  if (stopping_ || new_stack_) return;
  if (escalation_.stack().Check(now)) {
    escalation_.stack().Add(now);
    RestartStack(what, false);  // it is nothing that a program remembers
  } else {
    calls_.push_back("Again " + what + "; everything is stopped.");
    StopAll();
  }
}

// ---- what is due

void Supervisor::Step(Time now) {
  NoticeOwnPause(now);
  StepHealth(now);
  lifecycle_.KillOverdue(now);
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (lifecycle_.IsUp(i)) {
      StepUp(i, now);
    } else {
      StepDown(i, now);
    }
  }
}

void Supervisor::NoticeOwnPause(Time now) {
  if (now - last_step_ > kOwnPause) lifecycle_.ListenFrom(now);
  last_step_ = now;
}

void Supervisor::StepHealth(Time now) {
  bool any_wanted = false, all_ready = true;
  for (std::size_t group = 0; group < config_.groups.size(); ++group) {
    bool wanted = false, ready = true, waits = false, to_blame = false;
    for (const std::size_t member : config_.groups[group].processes) {
      if (!IsWanted(member)) continue;
      wanted = true;
      if (IsSatisfied(member)) continue;
      ready = false;
      const bool excused =
          status(member).phase == ProcessPhase::kUnreachable || MissingNeed(member);
      (excused ? waits : to_blame) = true;
    }
    any_wanted = any_wanted || wanted;
    all_ready = all_ready && ready;
    escalation_.SetReady(group, wanted && ready, now);
    if (waits && !to_blame) escalation_.Excuse(group, now);
    if (to_blame && !escalation_.IsGivenUp(group) && escalation_.IsOverdue(group, now)) {
      GiveUp(group, "in trouble for longer than " + SecondsText(config_.escalation.ask_within));
    }
  }
  escalation_.SetAllReady(any_wanted && all_ready, now);
}

void Supervisor::StepUp(std::size_t process, Time now) {
  if (lifecycle_.IsEnding(process)) return;
  Plan& plan = plans_[process];
  if (MustEnd(process)) {
    if (!DependentsEnd(process, now)) EndNow(process, now);
  } else if (lifecycle_.IsSilent(process, now)) {
    Fail(process, Cause::kEnd,
         "gave no sign of life for " + SecondsText(config_.processes[process].heartbeat->timeout),
         now);
  } else if (!lifecycle_.AwaitsReadiness(process)) {
    return;
  } else if (!lifecycle_.IsConnected(process)) {
    if (!lifecycle_.IsLate(process, now)) return;
    LoseHost(process, now);
    plan.end_first = true;
  } else if (lifecycle_.IsLate(process, now)) {
    Fail(process, Cause::kEnd,
         "was not ready within " + SecondsText(config_.processes[process].start_timeout), now);
  } else {
    const bool ready = config_.processes[process].ready == Readiness::kNone;
    lifecycle_.SetPhase(process, ready ? ProcessPhase::kReady : ProcessPhase::kStarting, "", now);
  }
}

// The phase says what comes after the end.
void Supervisor::EndNow(std::size_t process, Time now) {
  const Plan& plan = plans_[process];
  const std::size_t group = config_.processes[process].group;
  if (escalation_.IsGivenUp(group)) {
    lifecycle_.End(process, ProcessPhase::kGivenUp, escalation_.given_up(group), now);
  } else if (!IsWanted(process) || GivenUpAbove(process)) {
    lifecycle_.End(process, ProcessPhase::kStopped, "is ended", now);
  } else if (status(process).phase == ProcessPhase::kUnreachable) {
    lifecycle_.End(process, ProcessPhase::kUnreachable, plan.reason, now);
  } else {
    lifecycle_.End(process, ProcessPhase::kStarting, plan.reason, now);
  }
}

void Supervisor::StepDown(std::size_t process, Time now) {
  Plan& plan = plans_[process];
  const std::size_t group = config_.processes[process].group;
  if (escalation_.IsGivenUp(group)) {
    lifecycle_.SetPhase(process, ProcessPhase::kGivenUp, escalation_.given_up(group), now);
  } else if (!IsWanted(process)) {
    lifecycle_.SetPhase(process, ProcessPhase::kStopped, "", now);
    plan = {};
  } else if (const auto above = GivenUpAbove(process)) {
    lifecycle_.SetPhase(process, ProcessPhase::kStopped,
                        "needs " + config_.groups[*above].name + ", which is given up", now);
  } else if (plan.done) {
    return;
  } else if (now < plan.not_before) {
    const bool unreachable = status(process).phase == ProcessPhase::kUnreachable;
    lifecycle_.SetPhase(process,
                        unreachable ? ProcessPhase::kUnreachable : ProcessPhase::kBackingOff,
                        plan.reason, now, plan.not_before);
  } else if (IsEndingFirst(process, now)) {
    lifecycle_.SetPhase(process, ProcessPhase::kStarting, "waits for others to end", now);
  } else if (const auto needed = MissingDependency(process)) {
    lifecycle_.SetPhase(process, ProcessPhase::kStarting,
                        "waits for " + config_.processes[*needed].name, now);
  } else {
    Launch(process, now);
  }
}

void Supervisor::Launch(std::size_t process, Time now) {
  Plan& plan = plans_[process];
  Lifecycle::Start start;
  start.counts = plan.as_restart;
  start.cleared = plan.cleared;
  plan = {};
  if (const Outcome launched = lifecycle_.Launch(process, start, now); !launched) {
    Fail(process, Cause::kEnd, launched.problem(), now);
    return;
  }
  StepUp(process, now);
}

// ---- failures

Decision Supervisor::Fail(std::size_t process, Cause cause, const std::string& reason, Time now) {
  if (GivenUpAbove(process)) return {};
  // When something that it needs is down, that is the one to be counted: it will wait for it.
  if (MissingNeed(process)) {
    BeginWave({process}, {reason, now}, now);
    return {};
  }
  const std::size_t group = config_.processes[process].group;
  const Decision decision = escalation_.OnFailure(group, cause, now);
  if (decision.refused) return decision;
  const std::string why = config_.processes[process].name + " " + reason + "; " + decision.reason;
  switch (decision.step) {
    case EscalationStep::kGroup:
      BeginWave(order_.RestartedWith(process), {reason, now + decision.delay}, now);
      break;
    case EscalationStep::kClosure:
      BeginWave(order_.Members(order_.closure(decision.root)), {why, now, true}, now);
      break;
    case EscalationStep::kStack:
      RestartStack(why, true);
      break;
    case EscalationStep::kPerson:
      GiveUp(decision.root, why);
      break;
  }
  return decision;
}

// Its host does not answer: nobody's fault, so it is tried again and again, and not counted.
void Supervisor::LoseHost(std::size_t process, Time now) {
  Plan& plan = plans_[process];
  plan.reason =
      "host " + config_.hosts[*config_.processes[process].host].name + " cannot be reached";
  plan.not_before = now + kHostRetry;
  plan.as_restart = true;
  lifecycle_.SetPhase(process, ProcessPhase::kUnreachable, plan.reason, now, plan.not_before);
}

void Supervisor::BeginWave(const Indices& processes, const Restarting& how, Time now) {
  ++last_wave_;
  for (const std::size_t process : processes) {
    Plan& plan = plans_[process];
    if (!IsWanted(process) || plan.done) continue;
    plan.end_first = lifecycle_.IsUp(process);
    plan.as_restart = true;
    plan.cleared = how.cleared;
    plan.wave = last_wave_;
    plan.reason = how.reason;
    plan.not_before = how.not_before;
    if (const auto started = lifecycle_.started_at(process)) {
      const Duration floor = config_.groups[config_.processes[process].group].limits.floor;
      plan.not_before = std::max(plan.not_before, *started + floor);
    }
  }
  for (const std::size_t process : processes) {
    if (!lifecycle_.IsUp(process)) StepDown(process, now);
  }
}

void Supervisor::RestartStack(const std::string& reason, bool cleared) {
  new_stack_ = true;
  clear_stack_ = cleared;
  stack_reason_ = reason;
  ++revision_;
}

void Supervisor::GiveUp(std::size_t group, const std::string& reason) {
  escalation_.GiveUp(group, reason);
  const GroupConfig& config = config_.groups[group];
  if (config.essential) switch_.SafeStop();
  calls_.push_back("The robot has given up " + config.name + ": " + reason +
                   (switch_.safe_stop() ? ". It has stopped." : "."));
  ++revision_;
}

}  // namespace coppice::robot::processes
