// What Linux says about a computer and its processes, from the files in /proc and /sys
// (https://docs.kernel.org/filesystems/proc.html). Each function takes the folder that stands for
// "/", so that tests can hand in files; nothing means that the file is missing or not understood.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_PROC_FILES_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_PROC_FILES_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coppice::robot::monitoring {

/// Of all cores together since the start, in ticks. Waiting for disks is no work.
struct CpuTimes {
  std::uint64_t busy = 0, total = 0;
};
std::optional<CpuTimes> ReadCpuTimes(const std::string& root);

/// The hottest of all sensors (thermal zones and hardware monitors) in °C. Computers without
/// sensors, as virtual machines, have none.
std::optional<double> ReadTemperature(const std::string& root);

/// Share of the memory that is not available to a program that asks for it, 0..1.
std::optional<double> ReadMemoryUsed(const std::string& root);

/// Of one network interface since the start, both directions.
struct InterfaceCounters {
  std::uint64_t received = 0, sent = 0;  ///< bytes
  std::uint64_t errors = 0, drops = 0;   ///< packets
};
std::optional<InterfaceCounters> ReadInterface(const std::string& root, const std::string& name);

/// The links of this computer to others that are up, by name; loopback is none.
std::vector<std::string> ReadLinks(const std::string& root);
/// The interface is there, but down: no cable, no access point.
bool IsLinkDown(const std::string& root, const std::string& name);
/// Mbit/s; nothing for links that have no fixed speed, as Wi-Fi.
std::optional<double> ReadLinkSpeed(const std::string& root, const std::string& name);

struct ProcessUsage {
  double cpu_time = 0;  ///< s, user and system, of all threads
  double memory = 0;    ///< MB resident
  int threads = 0;
  std::optional<int> files;  ///< open file descriptors; nothing if it is another user's process
};
std::optional<ProcessUsage> ReadProcessUsage(const std::string& root, int pid);

/// Share of the disk's space that a program without privileges cannot use, 0..1. `path`: of any
/// file on it.
std::optional<double> ReadDiskUsed(const std::string& path);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_PROC_FILES_H_
