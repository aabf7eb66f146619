// The node of coppice-supervisor: connects the supervisor's core to ROS and to real processes.
//
//   /processes                    coppice_msgs/ProcessStates, latched, on change and at 1 Hz
//   /supervisor/restart           coppice_msgs/RestartProcess
//   /supervisor/reset             coppice_msgs/RestartProcess, see Supervisor::Reset
//   /supervisor/set_configuration coppice_msgs/SetConfiguration
//   /supervisor/release           std_srvs/Trigger, ends what was set by hand
//   /supervisor/set_site          coppice_msgs/SetSite, see Supervisor::SetSite
//   /supervisor/switch_off        coppice_msgs/SwitchOff, see switch_off.h
//
// One thread does everything, every 20 ms of wall time. Times in ProcessState are wall time,
// because processes live in the computer's time; header.stamp is ROS time as everywhere.
#ifndef COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_PROGRAM_H_
#define COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_PROGRAM_H_

#include <ros/ros.h>

#include <functional>
#include <string>
#include <vector>

#include "robot_app/common/node_probe.h"
#include "robot_app/common/service_caller.h"
#include "robot_app/processes/config/conditions.h"
#include "robot_app/processes/launch/parameter_launcher.h"
#include "robot_app/processes/launch/process_launcher.h"
#include "robot_app/processes/launch/remote_launcher.h"
#include "robot_app/processes/launch/ros_master.h"
#include "robot_app/processes/person_calls.h"
#include "robot_app/processes/supervisor.h"
#include "robot_app/processes/switch_off.h"

namespace coppice::robot::processes {

class SupervisorProgram {
 public:
  /// How a run has ended.
  enum class Ending {
    kStopped,    ///< as asked
    kNewStack,   ///< everything has ended and is to begin anew, with a new ROS master
    kSwitchOff,  ///< everything was stopped, and the power is to go off
    kNoMaster,   ///< the ROS master ended too often; everything was stopped
  };

  /// ros::init was called. Launcher and master must outlive it. `state_file`: where the
  /// supervisor's memory is kept. `memory_file`: what is in it is taken up; mostly the same.
  /// `switch_off_token`: see PowerDown.
  /// `address`: of this computer for nodes on other hosts; empty: that of the master.
  /// `check`: see Supervisor::SetSite.
  SupervisorProgram(RobotConfig config, PosixLauncher& launcher, const RosMaster& master,
                    const std::string& address, std::string state_file,
                    const std::string& memory_file, std::string switch_off_token, CheckSite check);

  Supervisor& supervisor() { return supervisor_; }

  /// Until `stop` says so or the stack is to begin anew; everything has stopped then.
  Ending Run(const std::function<bool()>& stop);

  /// What the state file could not be given; empty: it has all.
  std::string unsaved() const;

 private:
  struct Probed {
    std::size_t process;
    int pid;
  };

  void OfferServices();
  void OfferSite();
  void WatchConditions();
  void WatchHeartbeats();
  void Round();
  void ProbeMaster();
  void ProbeStarting();
  void TakeResult(std::size_t index);
  void Publish();
  void NotifySystemd() const;
  void Tell(std::size_t process);
  void Save();
  void FinishWriting();
  void SaveNow();
  void Saved(const SupervisorMemory& memory, const Outcome& saved);

  ros::NodeHandle handle_;
  WallClock clock_;
  PosixLauncher& local_;
  RemoteLauncher launcher_;
  ParameterLauncher parameters_;
  const RosMaster& master_;
  const std::string state_file_;
  Supervisor supervisor_;
  PersonCalls calls_;
  PowerDown switch_off_;
  const CheckSite check_site_;
  NodeProbe probe_, master_probe_;
  std::vector<Probed> probed_;
  Time master_asked_at_{};
  int master_silences_ = 0;  // in a row
  std::vector<TopicCondition> conditions_;
  bool master_ended_ = false;
  std::uint64_t published_ = 0;
  Time published_at_{};
  std::string saved_;            // what the file holds
  std::string unsaved_because_;  // empty: it holds all
  bool is_writing_ = false;
  std::vector<std::string> told_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Publisher processes_;
  ServiceCaller writer_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_PROGRAM_H_
