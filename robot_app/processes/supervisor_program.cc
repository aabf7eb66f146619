#include "robot_app/processes/supervisor_program.h"

#include <coppice_msgs/ProcessStates.h>
#include <coppice_msgs/RestartProcess.h>
#include <coppice_msgs/SetConfiguration.h>
#include <coppice_msgs/SetSite.h>
#include <coppice_msgs/SwitchOff.h>
#include <ros/callback_queue.h>
#include <sensor_msgs/BatteryState.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <systemd/sd-daemon.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <thread>
#include <utility>

#include "bt_core/model/utf8.h"
#include "robot_app/common/any_message.h"
#include "robot_app/processes/launch/never_wait.h"

namespace coppice::robot::processes {
namespace {

constexpr Duration kPause = std::chrono::milliseconds(2);
constexpr Duration kRound = std::chrono::milliseconds(20);
constexpr Duration kProbeDeadline = std::chrono::milliseconds(300);
constexpr Duration kMasterPeriod = std::chrono::seconds(1);
constexpr Duration kMasterDeadline = std::chrono::seconds(4);
constexpr int kMostSilences = 4;  // of the master in a row, each until the deadline
constexpr const char* kNobody = "/supervisor/nobody";  // for whom the master is asked every time
constexpr Duration kReportPeriod = std::chrono::seconds(1);
constexpr Duration kTimeForCalls = std::chrono::seconds(20);
constexpr std::size_t kLongestLine = 1000;  // bytes

Time RosNow() { return TimeFromNanoseconds(static_cast<std::int64_t>(ros::Time::now().toNSec())); }

ros::Time ToRos(Time time) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(ToNanoseconds(time)));
}

// Whoever asks says how something is called: as one line that a terminal does not obey.
template <class Response>
bool Reply(const Expected<std::string>& done, const std::string& request, Response& response) {
  response.message = done ? *done : done.problem();
  std::string line = request.substr(0, kLongestLine) + ": " + (done ? "" : "refused: ") +
                     response.message.substr(0, kLongestLine);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cout << PlainText(line, kLongestLine) << std::endl;
  return true;
}

SupervisorMemory Load(const std::string& path, Time now) {
  Expected<SupervisorMemory> memory = LoadMemory(path, now);
  if (memory) return *std::move(memory);
  std::cerr << "coppice-supervisor: " << path << " " << memory.problem() << "; it begins anew\n";
  return {};
}

}  // namespace

SupervisorProgram::SupervisorProgram(RobotConfig config, PosixLauncher& launcher,
                                     const RosMaster& master, const std::string& address,
                                     std::string state_file, const std::string& memory_file,
                                     std::string switch_off_token, CheckSite check)
    : local_(launcher),
      launcher_(
          launcher, config.hosts,
          {state_file,
           RosMaster{{address.empty() ? master.address.host : address, master.address.port}}.Uri(),
           config.stop_timeout}),
      parameters_(launcher_, master.address, config.parameters),
      master_(master),
      state_file_(std::move(state_file)),
      supervisor_(std::move(config), parameters_, Load(memory_file, clock_.Now())),
      calls_(supervisor_.config().given_up.command, launcher),
      switch_off_(!supervisor_.config().switch_off.empty(), std::move(switch_off_token)),
      check_site_(std::move(check)),
      probe_(master.address, "/supervisor"),
      master_probe_(master.address, "/supervisor") {
  processes_ = handle_.advertise<coppice_msgs::ProcessStates>("/processes", 10, true);
  OfferServices();
  OfferSite();
  WatchConditions();
  WatchHeartbeats();
}

void SupervisorProgram::OfferServices() {
  using Restart = coppice_msgs::RestartProcess;
  using Configure = coppice_msgs::SetConfiguration;
  using Release = std_srvs::Trigger;
  services_.push_back(handle_.advertiseService<Restart::Request, Restart::Response>(
      "/supervisor/restart",
      boost::function<bool(Restart::Request&, Restart::Response&)>([this](auto& ask, auto& say) {
        const Expected<std::string> done = supervisor_.Restart(ask.name, clock_.Now(), ask.cleared);
        say.ok = done.ok();
        return Reply(done, "restart " + ask.name, say);
      })));
  services_.push_back(handle_.advertiseService<Restart::Request, Restart::Response>(
      "/supervisor/reset",
      boost::function<bool(Restart::Request&, Restart::Response&)>([this](auto& ask, auto& say) {
        const Expected<std::string> done = supervisor_.Reset(ask.name, clock_.Now());
        say.ok = done.ok();
        return Reply(done, "reset " + ask.name, say);
      })));
  services_.push_back(handle_.advertiseService<Configure::Request, Configure::Response>(
      "/supervisor/set_configuration",
      boost::function<bool(Configure::Request&, Configure::Response&)>(
          [this](auto& ask, auto& say) {
            const Expected<std::string> done = supervisor_.SetConfiguration(
                ask.configuration, ask.manual ? Hand::kPerson : Hand::kTree,
                [this](std::size_t condition) { return conditions_[condition].Check(RosNow()); });
            say.ok = done.ok();
            return Reply(done, "set_configuration " + ask.configuration, say);
          })));
  using Off = coppice_msgs::SwitchOff;
  services_.push_back(handle_.advertiseService<Off::Request, Off::Response>(
      "/supervisor/switch_off",
      boost::function<bool(Off::Request&, Off::Response&)>([this](auto& ask, auto& say) {
        const Expected<std::string> done =
            switch_off_.Ask(ask.reason, ask.token, supervisor_, clock_.Now());
        say.ok = done.ok();
        return Reply(done, "switch_off", say);
      })));
  services_.push_back(handle_.advertiseService<Release::Request, Release::Response>(
      "/supervisor/release",
      boost::function<bool(Release::Request&, Release::Response&)>([this](auto&, auto& say) {
        say.success = true;
        return Reply(supervisor_.Release(), "release", say);
      })));
}

// Who is told that the site has changed may rely on it: it is on the disk then. One that cannot be
// written down would be forgotten when all begins anew: at the old site, and nobody would know.
void SupervisorProgram::OfferSite() {
  const CheckSite check = [this](const std::string& site) {
    const Outcome complete = check_site_(site);
    if (!complete) return complete;
    FinishWriting();
    return SaveMemory(supervisor_.RememberAt(site), state_file_);
  };
  using Site = coppice_msgs::SetSite;
  services_.push_back(handle_.advertiseService<Site::Request, Site::Response>(
      "/supervisor/set_site",
      boost::function<bool(Site::Request&, Site::Response&)>([this, check](auto& ask, auto& say) {
        const Expected<std::string> done =
            supervisor_.SetSite(ask.site, ask.manual ? Hand::kPerson : Hand::kTree, check);
        say.ok = done.ok();
        return Reply(done, "set_site " + ask.site, say);
      })));
}

void SupervisorProgram::WatchConditions() {
  for (const ConditionConfig& config : supervisor_.config().conditions) {
    conditions_.emplace_back(config);
  }
  for (TopicCondition& condition : conditions_) {
    const std::string& topic = condition.config().topic;
    if (condition.config().current) {
      subscribers_.push_back(handle_.subscribe<sensor_msgs::BatteryState>(
          topic, 5, [&condition](const sensor_msgs::BatteryState::ConstPtr& message) {
            condition.Observe(message->current, RosNow());
          }));
    } else {
      subscribers_.push_back(handle_.subscribe<std_msgs::Bool>(
          topic, 5, [&condition](const std_msgs::Bool::ConstPtr& message) {
            condition.Observe(message->data ? 1 : 0, RosNow());
          }));
    }
  }
}

void SupervisorProgram::WatchHeartbeats() {
  const auto& processes = supervisor_.config().processes;
  for (std::size_t i = 0; i < processes.size(); ++i) {
    if (!processes[i].heartbeat) continue;
    subscribers_.push_back(handle_.subscribe<AnyMessage>(
        processes[i].heartbeat->topic, 5, [this, i](const boost::shared_ptr<AnyMessage const>&) {
          supervisor_.OnHeartbeat(i, clock_.Now());
        }));
  }
}

SupervisorProgram::Ending SupervisorProgram::Run(const std::function<bool()>& stop) {
  while (!stop() && !supervisor_.stopping() && !switch_off_.may_cut() &&
         !supervisor_.NeedsNewStack(clock_.Now())) {
    Round();
  }
  const bool is_stopped = stop() || supervisor_.stopping();
  if (!is_stopped && !switch_off_.may_cut()) {
    std::cout << "the whole stack begins anew: " << supervisor_.stack_reason() << std::endl;
    SaveNow();
    return Ending::kNewStack;
  }
  supervisor_.StopAll();
  while (!supervisor_.AllStopped(clock_.Now())) Round();
  const Time give_up = clock_.Now() + kTimeForCalls;
  while (!calls_.idle() && clock_.Now() < give_up) Round();
  Publish();
  if (!is_stopped) {
    SaveNow();
    return Ending::kSwitchOff;
  }
  FinishWriting();
  if (!stop()) return Ending::kNoMaster;
  // Who stops a robot on purpose starts it afresh, where it is; only the counters stay.
  SupervisorMemory counters;
  counters.site = supervisor_.site();
  counters.restarts = supervisor_.Remember().restarts;
  KeepMemory(counters, state_file_);
  return Ending::kStopped;
}

void SupervisorProgram::Round() {
  GoOnAfterLoss();
  const ros::WallDuration round(std::chrono::duration<double>(kRound).count());
  ros::getGlobalCallbackQueue()->callAvailable(round);
  if (!ros::ok()) {
    supervisor_.OnMasterEnded(clock_.Now(), "the supervisor's ROS node was shut down from outside");
    round.sleep();  // the queue does not wait any more
  }
  local_.Reap([this](int pid, int wait_status) {
    if (pid == master_.pid) {
      master_ended_ = true;
      supervisor_.OnMasterEnded(clock_.Now());
    }
    supervisor_.OnExit(pid, wait_status, clock_.Now());
    calls_.OnExit(pid, wait_status, clock_.Now());
    launcher_.Forget(pid);
  });
  launcher_.KeepAlive(clock_.Now());
  supervisor_.Step(clock_.Now());
  for (std::string& call : supervisor_.TakeCalls()) {
    std::cout << call << std::endl;
    calls_.Add(std::move(call));
  }
  calls_.Step(clock_.Now());
  if (switch_off_.TakeStop(supervisor_, clock_.Now())) sync();
  ProbeMaster();
  ProbeStarting();
  if (supervisor_.revision() != published_ || clock_.Now() - published_at_ >= kReportPeriod) {
    Publish();
    Save();
    local_.KeepLogsShort();
  }
}

// With a master that hangs those who run go on, but no program can be started or asked for anything
// any more. It is ended, and all begins anew with another one. Who has started it himself, ends it.
void SupervisorProgram::ProbeMaster() {
  if (master_ended_ || master_.pid == 0) return;
  if (!master_probe_.busy()) {
    if (clock_.Now() - master_asked_at_ < kMasterPeriod) return;
    master_asked_at_ = clock_.Now();
    master_probe_.Begin({{kNobody, ""}}, kMasterDeadline);
  }
  if (!master_probe_.Work(Duration::zero())) return;
  const bool is_silent = master_probe_.results()[0].is_master_silent;
  master_silences_ = is_silent ? master_silences_ + 1 : 0;
  if (master_silences_ != kMostSilences) return;
  std::cout << "the ROS master hangs, and is ended" << std::endl;
  local_.Signal(master_.pid, SIGKILL);
}

// Asks those that were started whether they are ready.
void SupervisorProgram::ProbeStarting() {
  if (master_ended_) return;
  if (probe_.busy()) {
    if (!probe_.Work(Duration::zero())) return;
    for (std::size_t i = 0; i < probed_.size(); ++i) TakeResult(i);
    return;
  }
  std::vector<ProbeRequest> requests;
  probed_.clear();
  for (std::size_t i = 0; i < supervisor_.config().processes.size(); ++i) {
    if (!supervisor_.AwaitsReadiness(i)) continue;
    const ProcessConfig& process = supervisor_.config().processes[i];
    probed_.push_back({i, supervisor_.status(i).pid});
    ProbeRequest request;
    request.node = process.node;
    if (process.ready == Readiness::kTopic) request.topic = process.ready_name;
    if (process.ready == Readiness::kService) request.service = process.ready_name;
    requests.push_back(std::move(request));
  }
  if (!requests.empty()) probe_.Begin(std::move(requests), kProbeDeadline);
}

// The answer counts only if it comes from the process that we started: another one may have
// registered under the same name. What runs on another host has other numbers.
void SupervisorProgram::TakeResult(std::size_t index) {
  const ProbeResult& result = probe_.results()[index];
  const auto [process, pid] = probed_[index];
  const bool is_remote = supervisor_.config().processes[process].host.has_value();
  if (!result.answered || (!is_remote && getpgid(result.pid) != pid)) return;
  supervisor_.OnReady(process, pid, clock_.Now());
}

void SupervisorProgram::Publish() {
  const RobotConfig& config = supervisor_.config();
  coppice_msgs::ProcessStates message;
  message.header.stamp = ros::Time::now();
  message.site = supervisor_.site();
  message.configuration = supervisor_.configuration();
  message.changing = supervisor_.IsChanging();
  message.manual = supervisor_.configuration_switch().manual();
  message.safe_stop = supervisor_.configuration_switch().safe_stop();
  for (std::size_t i = 0; i < config.processes.size(); ++i) {
    const ProcessConfig& process = config.processes[i];
    const ProcessStatus& status = supervisor_.status(i);
    coppice_msgs::ProcessState state;
    state.name = process.name;
    state.node = process.node;
    state.group = config.groups[process.group].name;
    if (process.host) state.host = config.hosts[*process.host].name;
    state.state = static_cast<std::uint8_t>(status.phase);
    state.pid = status.pid;
    state.restarts = status.restarts;
    state.restarts_in_window =
        static_cast<std::uint32_t>(supervisor_.RestartsUsed(i, clock_.Now()));
    state.restarts_allowed =
        static_cast<std::uint32_t>(config.groups[process.group].limits.restarts);
    state.escalation = static_cast<std::uint8_t>(supervisor_.escalation(i));
    state.since = ToRos(status.since);
    state.back_off_until = ToRos(status.back_off_until);
    state.message = status.message;
    message.processes.push_back(state);
    Tell(i);
  }
  processes_.publish(message);
  NotifySystemd();
  published_ = supervisor_.revision();
  published_at_ = clock_.Now();
}

// By the same round that does the work, so that a round that hangs is noticed. Without systemd this
// does nothing (sd_notify(3)).
void SupervisorProgram::NotifySystemd() const {
  sd_notify(0, ("READY=1\nWATCHDOG=1\nSTATUS=" + supervisor_.configuration() +
                (supervisor_.IsChanging() ? ", changing" : ""))
                   .c_str());
}

// One line per change on the console.
void SupervisorProgram::Tell(std::size_t process) {
  const ProcessStatus& status = supervisor_.status(process);
  told_.resize(supervisor_.config().processes.size());
  const std::string line = supervisor_.config().processes[process].name + ": " +
                           ToString(status.phase) +
                           (status.pid == 0 ? "" : " (pid " + std::to_string(status.pid) + ")") +
                           (status.message.empty() ? "" : ", " + status.message);
  if (told_[process] == line) return;
  told_[process] = line;
  std::cout << line << std::endl;
}

std::string SupervisorProgram::unsaved() const {
  return unsaved_because_.empty() ? "" : ToText(supervisor_.Remember());
}

// On a thread of its own: whoever restarts programs waits for no disk. What cannot be written is
// tried again, until it can be.
void SupervisorProgram::Save() {
  writer_.RunFinished();
  const SupervisorMemory memory = supervisor_.Remember();
  if (is_writing_ || ToText(memory) == saved_) return;
  is_writing_ = writer_.Add([this, memory]() -> ServiceCaller::Finish {
    const Outcome saved = SaveMemory(memory, state_file_);
    return [this, memory, saved] {
      is_writing_ = false;
      Saved(memory, saved);
    };
  });
}

// What is written before this returns is not overwritten by something older.
void SupervisorProgram::FinishWriting() {
  while (is_writing_) {
    std::this_thread::sleep_for(kPause);
    writer_.RunFinished();
  }
}

void SupervisorProgram::SaveNow() {
  FinishWriting();
  const SupervisorMemory memory = supervisor_.Remember();
  if (ToText(memory) != saved_) Saved(memory, SaveMemory(memory, state_file_));
}

// The same problem is said once.
void SupervisorProgram::Saved(const SupervisorMemory& memory, const Outcome& saved) {
  if (saved) {
    saved_ = ToText(memory);
  } else if (saved.problem() != unsaved_because_) {
    std::cerr << "coppice-supervisor: " << saved.problem() << std::endl;
  }
  unsaved_because_ = saved.problem();
}

}  // namespace coppice::robot::processes
