// What is watched about a computer, as plain values.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_WATCH_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_WATCH_H_

#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

struct DiskWatch {
  std::string path;  ///< of any file on it
  Band used;         ///< share, 0..1
};

struct InterfaceWatch {
  /// eth0, ...; or a pattern (fnmatch(3)) for all links of this computer that are up, but for
  /// loopback: "*", "wl*". A link that a pattern does not match any more is no longer watched; one
  /// that is named must be there.
  std::string interface;
  double speed = 1000;  ///< of the link [Mbit/s], where the system does not tell it
  Band load;            ///< share of the speed, the busier direction, 0..1
  Band errors, drops;   ///< packets per second
};

/// Another computer of the robot.
struct Computer {
  std::string name;
  std::string address;

  bool operator==(const Computer& other) const {
    return name == other.name && address == other.address;
  }
};

/// The name of `host` that stands for every other computer on which nodes of the robot run.
inline constexpr char kEveryHost[] = "*";

/// Another computer's clock, asked by SNTP.
struct ClockWatch {
  std::string host;     ///< name, for people; or kEveryHost
  std::string address;  ///< where its time server answers
  int port = 123;
  Band offset;             ///< s, its clock less ours
  bool must_serve = true;  ///< silence is an error even if it has never answered
};

/// Another computer, asked for a TCP connection; a refusal is an answer too.
struct ReachWatch {
  std::string host;  ///< or kEveryHost
  std::string address;
  int port = 22;
  Band delay;  ///< s until the answer
};

/// The process behind a ROS node of this computer.
struct ProcessWatch {
  std::string node;
  Band cpu;      ///< share of one core
  Band memory;   ///< MB resident
  Band threads;  ///< number
  Band files;    ///< number of open file descriptors
};

struct SystemWatch {
  std::string host;      ///< whose monitor this is for; empty: of every computer
  Duration period{0};    ///< of the measurements
  Duration window{0};    ///< over which loads and rates are measured
  Band cpu_load;         ///< share of all cores, 0..1
  Band cpu_temperature;  ///< degrees Celsius, the hottest sensor
  Band memory_used;      ///< share, 0..1
  std::vector<DiskWatch> disks;
  std::vector<InterfaceWatch> interfaces;
  Duration ask_period{0};  ///< of the questions to other computers
  Duration deadline{0};    ///< for their answers
  std::vector<ClockWatch> clocks;
  std::vector<ReachWatch> hosts;
  std::vector<ProcessWatch> processes;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_WATCH_H_
