// Goes through a run for a ReplayPrinter.
#include <fnmatch.h>

#include <map>
#include <optional>

#include "bt_core/cli/replay/replay_printer.h"
#include "bt_core/frames/follower.h"

namespace coppice {
namespace {

class Walker {
 public:
  Walker(const Recording& run, const ReplayFilter& filter, ReplayPrinter& printer)
      : run_(run), filter_(filter), printer_(printer) {}

  ReplaySummary Print() {
    const auto& sections = run_.sections();
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const bool is_last = i + 1 == sections.size();
      PrintSection(sections[i], is_last ? run_.ticks().size() : sections[i + 1].first_tick);
    }
    PrintAsides(run_.ticks().size());
    if (run_.end() && filter_.Has(run_.end()->time)) printer_.End(*run_.end());
    summary_.closed = run_.is_closed();
    summary_.damages = run_.damages();
    summary_.duration = last_ - run_.start();
    printer_.Summary(summary_);
    return std::move(summary_);
  }

 private:
  void PrintSection(const Recording::Section& section, std::size_t end) {
    UseTree(section.tree);
    if (!follower_ || !FollowsOn(section)) {
      PrintAsides(section.first_tick);
      follower_.emplace(ShapeOf(*tree_), section.state);
      if (filter_.Has(section.state.time)) printer_.State(*tree_, section.state);
    }
    for (std::size_t i = section.first_tick; i < end; ++i) {
      PrintAsides(i);
      PrintTick(run_.EventsOf(i));
    }
  }

  void UseTree(std::size_t number) {
    if (number == tree_number_) return;
    tree_number_ = number;
    tree_ = &run_.trees()[number];
    printer_.Tree(*tree_);
    wanted_.clear();
    for (const DescribedNode& node : tree_->nodes) {
      if (!filter_.pattern.empty()) {
        wanted_.push_back(fnmatch(filter_.pattern.c_str(), node.path.c_str(), 0) == 0);
      }
      if (counted_.emplace(node.path, summary_.nodes.size()).second) {
        summary_.nodes.push_back({node.path});
      }
    }
  }

  // Notes and gaps that stand before a tick.
  void PrintAsides(std::size_t tick) {
    for (; gap_ < run_.gaps().size() && run_.gaps()[gap_].tick <= tick; ++gap_) {
      const HistoryGap& gap = run_.gaps()[gap_].gap;
      if (!filter_.Has(gap.time)) continue;
      ++summary_.gaps;
      summary_.lost_ticks += gap.lost_ticks;
      summary_.lost_notes += gap.lost_notes;
      printer_.Gap(gap);
    }
    for (; note_ < run_.notes().size() && run_.notes()[note_].tick <= tick; ++note_) {
      const HistoryNote& note = run_.notes()[note_].note;
      if (!filter_.Has(note.time)) continue;
      ++summary_.notes;
      printer_.Note(note);
    }
  }

  void PrintTick(const TickEvents& events) {
    const ToldTick tick = TellTick(*tree_, *follower_, events, wanted_);
    if (tick.is_empty() || !filter_.Has(events.start)) return;
    last_ = std::max(last_, events.start);
    Count(tick);
    printer_.Tick(tick);
  }

  void Count(const ToldTick& tick) {
    ++summary_.ticks;
    summary_.changes += tick.changes.size();
    summary_.writes += tick.writes.size();
    for (const ToldTick::Change& change : tick.changes) {
      ReplaySummary::Node& node = summary_.nodes[counted_[change.node]];
      node.successes += change.to == Status::kSuccess;
      node.failures += change.to == Status::kFailure;
    }
  }

  const Recording& run_;
  const ReplayFilter& filter_;
  ReplayPrinter& printer_;
  ReplaySummary summary_;
  const TreeDescription* tree_ = nullptr;
  std::size_t tree_number_ = SIZE_MAX;
  std::vector<bool> wanted_;
  std::map<std::string, std::size_t> counted_;
  std::optional<HistoryFollower> follower_;
  std::size_t gap_ = 0;
  std::size_t note_ = 0;
  Time last_{run_.start()};
};

}  // namespace

ReplaySummary PrintRun(const Recording& run, const ReplayFilter& filter, ReplayPrinter& printer) {
  return Walker(run, filter, printer).Print();
}

}  // namespace coppice
