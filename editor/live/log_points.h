// Places of trees at which a line is written into the log when a node does something. Unlike a
// breakpoint a log-point costs the robot nothing: RunLog (run_log.h) finds the lines in what was
// received, also of what happened before the log-point was there, and in records.
#ifndef COPPICE_EDITOR_LIVE_LOG_POINTS_H_
#define COPPICE_EDITOR_LIVE_LOG_POINTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::editor {

struct LogPoint {
  std::uint32_t number = 0;    ///< counts from 1; another one after every change
  std::string run;             ///< name of a RunSource; empty: every run
  std::string path;            ///< of the node, as Program::Path
  std::string text;            ///< "{port}" and "{key}" stand for values; empty: only the status
  std::string condition;       ///< a script as that of a breakpoint; empty: always
  std::uint32_t from_hit = 1;  ///< writes from so many hits on; what the condition forbids is none
  bool enabled = true;
};

/// "text if battery < 20 #3", as it is typed.
std::string ToString(const LogPoint& point);
/// Reads text, condition and hit count into `point`.
Outcome ReadLogPoint(const std::string& typed, LogPoint& point);

class LogPoints {
 public:
  const std::vector<LogPoint>& all() const { return all_; }
  /// Of that run or of every run, at a path; null: there is none.
  const LogPoint* FindAt(const std::string& run, const std::string& path) const;

  void Add(LogPoint point);
  void Remove(std::uint32_t number);
  void Change(std::uint32_t number, LogPoint point);

  /// Another number after every change.
  std::uint64_t version() const { return version_; }

 private:
  std::vector<LogPoint> all_;
  std::uint32_t last_number_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_LOG_POINTS_H_
