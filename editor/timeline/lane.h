// What one node did over a run: which status it had from which tick on. Asked for a range of ticks,
// it says which statuses occur in it, at once however long the range is; so a line of a thousand
// pixels over ten million events is drawn in well under a millisecond.
//
//   Lane lane;
//   lane.Set(7, Status::kRunning);
//   lane.Set(9, Status::kSuccess);
//   lane.Seen(7, 12);              // RUNNING and SUCCESS
#ifndef COPPICE_EDITOR_TIMELINE_LANE_H_
#define COPPICE_EDITOR_TIMELINE_LANE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bt_core/base/status.h"

namespace coppice::editor {

/// A set of statuses, one bit for each.
using StatusSet = std::uint8_t;
inline constexpr StatusSet SetOf(Status status) {
  return static_cast<StatusSet>(1U << static_cast<unsigned>(status));
}

class Lane {
 public:
  /// The status from this tick on. Ticks are those of Recording::ticks() and never fall; the last
  /// word about a tick counts. At most 2^29 ticks.
  void Set(std::size_t tick, Status status);
  /// In this tick it ended and has begun again: the status, which is set, is a new one.
  void Restart(std::size_t tick);

  /// kIdle before the first.
  Status At(std::size_t tick) const;
  /// The tick in which the status of that tick began; 0 if it was never set before.
  std::size_t Since(std::size_t tick) const;

  /// Which statuses occur in the ticks from `first` up to and without `end`; none if that is empty.
  StatusSet Seen(std::size_t first, std::size_t end) const;

  /// The next tick after this one, or the last before it, in which another status begins; the same
  /// tick if there is none.
  std::size_t NextChange(std::size_t tick) const;
  std::size_t ChangeBefore(std::size_t tick) const;

  std::size_t changes() const { return entries_.size(); }

 private:
  static constexpr std::size_t kFan = 16;
  static std::size_t TickOf(std::uint32_t entry) { return entry >> 3; }
  static Status StatusOf(std::uint32_t entry) { return static_cast<Status>(entry & 7); }

  std::size_t FirstBehind(std::size_t tick) const;
  StatusSet SeenAmong(std::size_t first, std::size_t end) const;
  void Put(std::size_t tick, Status status);
  void Summarise();

  std::vector<std::uint32_t> entries_;          // tick * 8 + status
  std::vector<std::vector<StatusSet>> levels_;  // [k][i]: among entries i * 16^(k+1) and on
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_LANE_H_
