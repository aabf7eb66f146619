#include "robot_app/deployment/robot/programs.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace coppice::robot::deployment {
namespace {

using processes::ProcessConfig;
using processes::Supervisor;

constexpr double kEndsAfter = 0.3;  // s, after SIGTERM
// What crashes with the program that loops.
constexpr const char* kDependents[] = {"/localization", "/navigation"};

}  // namespace

Programs::Programs(World& world, const processes::RobotConfig& config)
    : world_(world),
      config_(config),
      lives_(config_.processes.size()),
      supervisor_(std::make_unique<Supervisor>(config_, *this)),
      chance_(world.seed, "programs") {
  for (const ProcessConfig& process : config_.processes) nodes_.push_back(process.node);
}

int Programs::IndexOf(const std::string& node) const {
  const auto found = std::find(nodes_.begin(), nodes_.end(), node);
  return found == nodes_.end() ? -1 : static_cast<int>(found - nodes_.begin());
}

std::size_t Programs::IndexOf(const ProcessConfig& config) const {
  const auto found =
      std::find_if(config_.processes.begin(), config_.processes.end(),
                   [&](const ProcessConfig& process) { return process.name == config.name; });
  return static_cast<std::size_t>(found - config_.processes.begin());
}

bool Programs::Works(const std::string& node) const {
  const int index = IndexOf(node);
  if (index < 0) return false;
  const Life& life = lives_[static_cast<std::size_t>(index)];
  return life.is_ready && !life.hangs;
}

double Programs::Rate(const std::string& node) const {
  if (!Works(node)) return 0;
  return lives_[static_cast<std::size_t>(IndexOf(node))].rate;
}

monitoring::ProcessTable Programs::Table() const {
  monitoring::ProcessTable table;
  table.configuration = supervisor_->configuration();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const processes::ProcessStatus& status = supervisor_->status(i);
    table.by_node[nodes_[i]] = {status.phase, status.pid, status.message};
  }
  return table;
}

// ---- faults

void Programs::Fail(Life& life, const std::string& fault) {
  if (!life.fault.empty()) return;
  life.fault = fault;
  life.failed = world_.now();
}

void Programs::Crash(const std::string& node, const std::string& fault) {
  const int index = IndexOf(node);
  if (index < 0 || lives_[static_cast<std::size_t>(index)].pid == 0) return;
  Life& life = lives_[static_cast<std::size_t>(index)];
  Fail(life, fault);
  life.ends = world_.now();
  life.status = SIGSEGV;
}

void Programs::Hang(const std::string& node) {
  const int index = IndexOf(node);
  if (index < 0 || lives_[static_cast<std::size_t>(index)].pid == 0) return;
  Fail(lives_[static_cast<std::size_t>(index)], "hang");
  lives_[static_cast<std::size_t>(index)].hangs = true;
}

void Programs::Slow(const std::string& node, double rate) {
  const int index = IndexOf(node);
  if (index < 0) return;
  Fail(lives_[static_cast<std::size_t>(index)], rate > 0 ? "slow" : "silent");
  lives_[static_cast<std::size_t>(index)].rate = rate;
}

void Programs::BeginCrashLoop(const std::string& node, bool in_program) {
  loop_ = IndexOf(node);
  loop_in_program_ = in_program;
  loop_starts_ = 0;
  Crash(node, "crash loop");
  TakeOthersAlong();
}

void Programs::TakeOthersAlong() {
  for (const char* node : kDependents) {
    if (chance_.Happens(world_.scenario.loop_takes_others)) Crash(node, "crash loop");
  }
}

// ---- the launcher

Expected<int> Programs::Start(const ProcessConfig& config) {
  const std::size_t index = IndexOf(config);
  Life& life = lives_[index];
  const std::string fault = life.fault;
  const Time failed = life.failed;
  const bool is_cleared = life.is_cleared;
  life = {};
  life.fault = fault;
  life.failed = failed;
  life.is_cleared = is_cleared;
  life.pid = ++last_pid_;
  life.ready = world_.now() + Seconds(chance_.Uniform(world_.scenario.program_start_shortest,
                                                      world_.scenario.program_start_longest));
  if (static_cast<int>(index) == loop_) {
    life.ends = world_.now() + Seconds(chance_.Uniform(world_.scenario.loop_crash_earliest,
                                                       world_.scenario.loop_crash_latest));
    life.status = SIGSEGV;
    if (++loop_starts_ == static_cast<int>(world_.scenario.loop_noticed_after)) {
      world_.After(0, [this] {
        if (on_loop_noticed) on_loop_noticed();
      });
    }
  }
  return life.pid;
}

void Programs::Signal(int pid, int signal) {
  for (Life& life : lives_) {
    if (life.pid != pid) continue;
    const bool is_killed = signal == SIGKILL;
    if (life.hangs && !is_killed) return;  // it does not hear
    life.ends = std::min(life.ends, world_.now() + Seconds(is_killed ? 0 : kEndsAfter));
    life.status = signal;
  }
}

Outcome Programs::ClearState(const ProcessConfig& config) {
  const std::size_t index = IndexOf(config);
  lives_[index].is_cleared = true;
  if (static_cast<int>(index) == loop_ && loop_in_program_) EndCrashLoop();
  return {};
}

// ---- what is due

void Programs::EndDue() {
  for (std::size_t i = 0; i < lives_.size(); ++i) {
    Life& life = lives_[i];
    if (life.pid == 0 || life.ends > world_.now()) continue;
    const int pid = std::exchange(life.pid, 0);
    const bool loops = static_cast<int>(i) == loop_ && life.status == SIGSEGV;
    life.is_ready = false;
    if (loops) Fail(life, "crash loop");
    if (on_end) on_end(nodes_[i]);
    if (loops) TakeOthersAlong();
    supervisor_->OnExit(pid, life.status, world_.now());
  }
}

void Programs::NoteReady(std::size_t process) {
  Life& life = lives_[process];
  if (!life.fault.empty()) {
    world_.journal.starts.push_back({config_.groups[config_.processes[process].group].name,
                                     life.failed, SecondsOf({life.failed, world_.now()}),
                                     life.fault});
  }
  life.fault.clear();
  if (on_ready) on_ready(nodes_[process], life.is_cleared);
  life.is_cleared = false;
}

void Programs::BecomeReady() {
  for (std::size_t i = 0; i < lives_.size(); ++i) {
    Life& life = lives_[i];
    if (life.pid == 0 || life.ready > world_.now()) continue;
    if (!life.is_ready) {
      life.is_ready = true;
      NoteReady(i);
    }
    supervisor_->OnReady(i, life.pid, world_.now());
    if (!life.hangs) supervisor_->OnHeartbeat(i, world_.now());
  }
}

std::vector<std::string> Programs::Step() {
  EndDue();
  BecomeReady();
  supervisor_->Step(world_.now());
  std::vector<std::string> calls = supervisor_->TakeCalls();
  if (supervisor_->NeedsNewStack(world_.now())) {
    if (loops()) EndCrashLoop();
    const processes::SupervisorMemory memory = supervisor_->Remember();
    supervisor_ = std::make_unique<Supervisor>(config_, *this, memory);
    supervisor_->Step(world_.now());
  }
  return calls;
}

bool Programs::IsBusy() const {
  return supervisor_->IsChanging() ||
         std::any_of(lives_.begin(), lives_.end(), [](const Life& life) {
           return !life.fault.empty() || (life.pid != 0 && (!life.is_ready || life.ends != kNever));
         });
}

void Programs::RestartAll() {
  EndCrashLoop();
  (void)supervisor_->Reset("all", world_.now());
  (void)supervisor_->Restart("all", world_.now(), true);
}

void Programs::PowerUp() {
  EndCrashLoop();
  lives_.assign(lives_.size(), {});
  supervisor_ = std::make_unique<Supervisor>(config_, *this);
}

}  // namespace coppice::robot::deployment
