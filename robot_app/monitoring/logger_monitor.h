// Does the logger log? A file or folder must change, or a topic must report.
//
// All times are wall time: a disk is full, or a database gone, in the computer's time.
#ifndef COPPICE_ROBOT_APP_MONITORING_LOGGER_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_LOGGER_MONITOR_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// By what one sees that something was written.
struct Footprint {
  std::uint64_t size = 0;       ///< bytes, of all files together
  std::int64_t last_write = 0;  ///< of the newest file, in ticks of the file system's clock

  bool operator==(const Footprint& other) const {
    return size == other.size && last_write == other.last_write;
  }
};

/// Of a file, or of all files in a folder and below; nothing if there is no such thing. Where
/// nothing has that name, it is a pattern (glob(7)): of all files and folders that match.
std::optional<Footprint> ReadFootprint(const std::string& path);

class LoggerMonitor : public Monitor {
 public:
  /// Relative paths begin in `folder`.
  explicit LoggerMonitor(std::string folder) : folder_(std::move(folder)) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.loggers); }
  /// Watches these from now on; one that stays the same keeps what was seen.
  void Watch(const std::vector<LoggerWatch>& loggers);
  /// A logger's topic has reported.
  void OnMessage(const std::string& topic, Time now);

  /// Looks at the files. One finding per logger; value: seconds since it last wrote or reported.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  void Look(Time now);

  struct Logger {
    LoggerWatch watch;
    std::optional<Footprint> footprint;
    std::optional<Time> alive_at;  // or the first report
  };
  std::string folder_;
  std::vector<Logger> loggers_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_LOGGER_MONITOR_H_
