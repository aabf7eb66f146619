#include "robot_app/monitoring/logger_monitor.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {
namespace {

namespace fs = std::filesystem;

bool IsSame(const LoggerWatch& a, const LoggerWatch& b) {
  return a.name == b.name && a.path == b.path && a.topic == b.topic;
}

void Add(const fs::directory_entry& file, Footprint& footprint) {
  std::error_code error;
  const std::uintmax_t size = file.file_size(error);
  if (error) return;  // gone in the meantime, or no regular file
  footprint.size += size;
  const fs::file_time_type time = file.last_write_time(error);
  if (!error) {
    footprint.last_write =
        std::max<std::int64_t>(footprint.last_write, time.time_since_epoch().count());
  }
}

void AddFolder(const std::string& path, Footprint& footprint) {
  std::error_code error;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator file(path, options, error), end; !error && file != end;
       file.increment(error)) {
    if (file->is_regular_file(error)) Add(*file, footprint);
  }
}

// What there is of that name, or else all that is there by that pattern.
std::vector<std::string> PathsOf(const std::string& pattern) {
  std::error_code error;
  if (fs::exists(pattern, error)) return {pattern};
  std::vector<std::string> paths;
  glob_t found{};
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0) {
    paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  }
  globfree(&found);
  return paths;
}

}  // namespace

std::optional<Footprint> ReadFootprint(const std::string& path) {
  const std::vector<std::string> paths = PathsOf(path);
  if (paths.empty()) return std::nullopt;
  Footprint footprint{0, std::numeric_limits<std::int64_t>::min()};
  for (const std::string& one : paths) {
    std::error_code error;
    const fs::directory_entry entry(one, error);
    if (error) continue;
    if (entry.is_directory(error)) {
      AddFolder(one, footprint);
    } else {
      Add(entry, footprint);
    }
  }
  return footprint;
}

void LoggerMonitor::Watch(const std::vector<LoggerWatch>& loggers) {
  std::vector<Logger> watched;
  for (const LoggerWatch& watch : loggers) {
    Logger logger{watch, std::nullopt, std::nullopt};
    for (const Logger& known : loggers_) {
      if (IsSame(known.watch, watch)) logger = known;
    }
    logger.watch = watch;
    watched.push_back(std::move(logger));
  }
  loggers_ = std::move(watched);
}

void LoggerMonitor::Look(Time now) {
  for (Logger& logger : loggers_) {
    if (logger.watch.path.empty()) continue;
    const auto footprint = ReadFootprint(fs::path(folder_) / logger.watch.path);
    if (footprint && !(footprint == logger.footprint)) logger.alive_at = now;
    logger.footprint = footprint;
  }
}

void LoggerMonitor::OnMessage(const std::string& topic, Time now) {
  for (Logger& logger : loggers_) {
    if (logger.watch.topic == topic) logger.alive_at = now;
  }
}

std::vector<Finding> LoggerMonitor::Report(const ProcessTable& processes, const Times& now) {
  Look(now.wall);
  std::vector<Finding> findings;
  for (Logger& logger : loggers_) {
    const LoggerWatch& watch = logger.watch;
    if (processes.IsStarting(watch.node)) logger.alive_at.reset();
    if (!logger.alive_at) logger.alive_at = now.wall;
    const double silence = InSeconds(now.wall - *logger.alive_at);
    Finding finding{"logger", watch.name, watch.node, leaves::HealthLevel::kOk, silence, "s",
                    "",       now.ros,    ""};
    if (now.wall - *logger.alive_at > watch.staleness) {
      finding.level = leaves::HealthLevel::kError;
      const bool is_missing = !watch.path.empty() && !logger.footprint;
      finding.message = is_missing           ? watch.path + " is missing"
                        : watch.path.empty() ? "no report for " + ToText(silence) + " s"
                                             : "nothing written for " + ToText(silence) + " s";
    }
    ApplyGrace(processes, watch.node, finding);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
