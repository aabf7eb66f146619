// One look at this computer: what the operating system says of it at one time. To look can take
// long - the kernel lets readers wait while a driver brings a link up, a network disk may hang - so
// it is for a thread of its own (regular_answers.h); what is made of it is system_monitor.h.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_SAMPLE_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_SAMPLE_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/monitoring/system/proc_files.h"

namespace coppice::robot::monitoring {

/// What to look at, beside what every computer has.
struct SystemQuestion {
  std::vector<std::string> disks;   ///< paths
  std::vector<std::string> links;   ///< names
  std::map<std::string, int> pids;  ///< of the processes of ROS nodes; 0: does not run

  bool operator==(const SystemQuestion& other) const {
    return disks == other.disks && links == other.links && pids == other.pids;
  }
};

struct LinkSample {
  std::optional<InterfaceCounters> counters;  ///< nothing: no such interface
  bool is_down = false;
  std::optional<double> speed;  ///< Mbit/s
};

struct ProcessSample {
  int pid = 0;
  ProcessUsage usage;
};

/// Everything by the names of the question.
struct SystemSample {
  Time time{};  ///< when the look began; what counts was read then
  std::optional<CpuTimes> cpu;
  std::optional<double> temperature;                   ///< °C
  std::optional<double> memory_used;                   ///< share
  std::vector<std::string> links_up;                   ///< all of this computer
  std::map<std::string, std::optional<double>> disks;  ///< share; nothing: no such disk
  std::map<std::string, LinkSample> links;
  std::map<std::string, ProcessSample> processes;  ///< those that run
};

/// `root`: the folder that stands for "/", for /proc and /sys.
SystemSample LookAtSystem(const std::string& root, const SystemQuestion& question, Time now);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_SAMPLE_H_
