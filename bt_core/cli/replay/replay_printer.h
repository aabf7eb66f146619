// The two faces of `coppice replay`: lines for people, and JSON objects for scripts.
#ifndef COPPICE_BT_CORE_CLI_REPLAY_REPLAY_PRINTER_H_
#define COPPICE_BT_CORE_CLI_REPLAY_REPLAY_PRINTER_H_

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/analysis/recording.h"
#include "bt_core/cli/event_json.h"

namespace coppice {

/// What of a run is printed.
struct ReplayFilter {
  std::string pattern;  ///< a shell pattern for paths; empty: all nodes
  Time from = Time::min();
  Time to = kNever;

  bool Has(Time time) const { return from <= time && time <= to; }
};

/// Counted while the run goes by.
struct ReplaySummary {
  struct Node {
    std::string path;
    std::uint64_t successes = 0;
    std::uint64_t failures = 0;
  };
  std::vector<Node> nodes;
  std::uint64_t ticks = 0;  ///< in which something happened
  std::uint64_t changes = 0;
  std::uint64_t writes = 0;
  std::uint64_t notes = 0;
  std::uint64_t gaps = 0;
  std::uint64_t lost_ticks = 0;
  std::uint64_t lost_notes = 0;
  Duration duration{0};
  bool closed = false;
  std::size_t damages = 0;

  /// Nothing is missing in the record.
  bool complete() const { return closed && damages == 0 && gaps == 0; }
};

class ReplayPrinter {
 public:
  virtual ~ReplayPrinter() = default;
  virtual void Tree(const TreeDescription& tree) = 0;
  virtual void State(const TreeDescription&, const HistoryState&) {}
  virtual void Tick(const ToldTick& tick) = 0;
  virtual void Note(const HistoryNote& note) = 0;
  virtual void Gap(const HistoryGap& gap) = 0;
  virtual void End(const HistoryEnd& end) = 0;
  virtual void Summary(const ReplaySummary& summary) = 0;
};

/// Times are shown in seconds since `start`.
std::unique_ptr<ReplayPrinter> MakeTextPrinter(std::ostream& out, Time start);
/// See event_json.h.
std::unique_ptr<ReplayPrinter> MakeJsonPrinter(std::ostream& out);

/// Prints a run from its first entry to its last.
ReplaySummary PrintRun(const Recording& run, const ReplayFilter& filter, ReplayPrinter& printer);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_REPLAY_REPLAY_PRINTER_H_
