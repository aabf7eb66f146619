// The lines that log-points write about a run, made from its history as far as it is known. A line
// is written whenever the node begins to run or returns something: not again in every tick in which
// it goes on.
#ifndef COPPICE_EDITOR_LIVE_RUN_LOG_H_
#define COPPICE_EDITOR_LIVE_RUN_LOG_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/analysis/recorded_tree.h"
#include "bt_core/frames/follower.h"
#include "editor/live/log_points.h"
#include "editor/timeline/run.h"

namespace coppice::editor {

struct LogLine {
  std::size_t tick = 0;  ///< of the run (run.h)
  NodeIndex node{0};     ///< of the tree of that tick
  std::string path;      ///< of the node
  Status status = Status::kIdle;
  std::string text;
};

class RunLog {
 public:
  static constexpr std::size_t kMostLines = 5000;  ///< the newest are kept

  RunLog();
  ~RunLog();
  RunLog(RunLog&&) noexcept;
  RunLog& operator=(RunLog&&) noexcept;

  /// Looks at so many further ticks; begins anew if the log-points have changed. `name` is that of
  /// the run.
  void Update(const Run& run, const std::string& name, const LogPoints& points,
              std::size_t most_ticks = 4000);
  /// Whether there is more to look at.
  bool is_behind(const Run& run) const { return is_wanted_ && next_ < run.size(); }

  const std::deque<LogLine>& lines() const { return lines_; }
  /// How often a log-point was hit.
  std::uint32_t HitsOf(std::uint32_t point) const;
  /// Why its condition cannot be computed; empty: it can.
  std::string ProblemOf(std::uint32_t point) const;

 private:
  struct Watch;  // a log-point in the present tree

  void Restart(const Run& run, const std::string& name, const LogPoints& points);
  void EnterSections(const Run& run);
  void EnterTree(const TreeDescription& tree);
  void Look(const Run& run, const TickEvents& events);
  void OnResult(const Event& event, std::size_t tick);
  bool IsHit(Watch& watch);

  const Run* run_ = nullptr;
  std::uint64_t version_ = 0;
  bool is_wanted_ = false;
  std::vector<LogPoint> points_;  // enabled, of this run
  std::size_t next_ = 0;          // tick to look at
  std::size_t section_ = 0;       // to enter next
  std::size_t tree_number_ = 0;
  std::optional<HistoryFollower> follower_;
  std::optional<RecordedTree> tree_;
  std::vector<Watch> watches_;
  std::vector<bool> is_watched_;  // by node
  std::deque<LogLine> lines_;
  std::map<std::uint32_t, std::uint32_t> hits_;
  std::map<std::uint32_t, std::string> problems_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_LOG_H_
