// The robot's programs in one process under simulated time: they load, work, end, hang, fall silent
// and forget, and the real process supervisor looks after them.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_PROGRAMS_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_PROGRAMS_H_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robot_app/deployment/scenario/chance.h"
#include "robot_app/deployment/world/world.h"
#include "robot_app/monitoring/process_table.h"
#include "robot_app/processes/supervisor.h"

namespace coppice::robot::deployment {

class Programs : public processes::ProcessLauncher {
 public:
  Programs(World& world, const processes::RobotConfig& config);

  // --- what others see of a node; one that is no program of the configuration is not there ---
  bool Works(const std::string& node) const;   ///< ready, and does not hang
  double Rate(const std::string& node) const;  ///< of its topics, of what it should be: 0..1
  monitoring::ProcessTable Table() const;
  const std::vector<std::string>& nodes() const { return nodes_; }

  // --- faults ---
  void Crash(const std::string& node, const std::string& fault);
  void Hang(const std::string& node);
  /// Its topics go on at that share of their rate.
  void Slow(const std::string& node, double rate);
  /// From now on the program crashes soon after every start, until its state is cleared, or, if it
  /// is not `in_program`, until the whole stack was restarted.
  void BeginCrashLoop(const std::string& node, bool in_program);
  bool loops() const { return loop_ >= 0; }
  void EndCrashLoop() { loop_ = -1; }

  // --- the supervisor ---
  processes::Supervisor& supervisor() { return *supervisor_; }
  const processes::Supervisor& supervisor() const { return *supervisor_; }
  /// Lets it know what has happened until now, and do what is due. Returns its calls for a person.
  std::vector<std::string> Step();
  /// Something is about to change.
  bool IsBusy() const;
  /// By hand: everything begins anew from a cleared state.
  void RestartAll();
  /// After the power was off.
  void PowerUp();

  std::function<void(const std::string& node, bool cleared)> on_ready;
  std::function<void(const std::string& node)> on_end;
  std::function<void()> on_loop_noticed;

  Expected<int> Start(const processes::ProcessConfig& config) override;
  void Signal(int pid, int signal) override;
  Outcome ClearState(const processes::ProcessConfig& config) override;
  bool IsConnected(int) const override { return true; }

 private:
  struct Life {
    int pid = 0;  // 0: it does not run
    Time ready = kNever;
    Time ends = kNever;
    int status = 0;  // of waitpid
    bool is_ready = false;
    bool hangs = false;
    bool is_cleared = false;
    double rate = 1;
    std::string fault;  // that it had; empty: none
    Time failed{};
  };
  int IndexOf(const std::string& node) const;
  std::size_t IndexOf(const processes::ProcessConfig& config) const;
  void Fail(Life& life, const std::string& fault);
  void EndDue();
  void BecomeReady();
  void NoteReady(std::size_t process);
  void TakeOthersAlong();

  World& world_;
  const processes::RobotConfig config_;
  std::vector<std::string> nodes_;
  std::vector<Life> lives_;  // by process
  std::unique_ptr<processes::Supervisor> supervisor_;
  Chance chance_;
  int last_pid_ = 100;
  int loop_ = -1;  // process that crashes after every start
  bool loop_in_program_ = false;
  int loop_starts_ = 0;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_PROGRAMS_H_
