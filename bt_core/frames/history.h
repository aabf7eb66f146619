// What a history consists of, as values: the tree, how it stands, then tick by tick what happens.
// A record (bt_core/record) and the live socket (bt_core/live) carry the same frames, which
// HistoryEncoder makes and HistoryDecoder takes apart; docs/record_format.md describes them.
#ifndef COPPICE_BT_CORE_FRAMES_HISTORY_H_
#define COPPICE_BT_CORE_FRAMES_HISTORY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/engine/events.h"
#include "bt_core/frames/tree_description.h"

namespace coppice {

/// How a tree stands after a tick.
struct HistoryState {
  enum class Cause : std::uint8_t {
    kBegin = 0,     ///< the history, or one of its files, begins here
    kLost = 1,      ///< events are missing before this; a gap says how many
    kJump = 2,      ///< the tree was given another program or another state
    kKeyframe = 3,  ///< nothing has happened: a place to begin reading
  };
  Cause cause = Cause::kBegin;
  std::uint64_t tick = 0;  ///< number of the last tick
  Time time{};             ///< its start, in the tree's clock
  std::vector<Status> statuses;
  std::vector<Status> last;         ///< per node: last status that was not IDLE; kIdle: not known
  std::vector<std::string> values;  ///< per slot, as in data/value_bytes.h
};

/// Events that are missing. The state of the tree follows.
struct HistoryGap {
  enum class Cause : std::uint8_t {
    kStream = 0,  ///< the listeners of the EventStream were too slow
    kOutput = 1,  ///< the disk or the connection was too slow
  };
  Cause cause = Cause::kStream;
  Time time{};                   ///< of the last tick before the state that follows
  std::uint64_t lost_ticks = 0;  ///< and halts
  std::uint64_t first_tick = 0;  ///< number of the first and the last of them
  std::uint64_t last_tick = 0;
  std::uint64_t lost_notes = 0;
};

/// Something that the application wanted to be known.
struct HistoryNote {
  Time time{};  ///< in the tree's clock
  std::string kind;
  std::string text;
};

/// The history was closed in order.
struct HistoryEnd {
  /// What follows.
  enum class Cause : std::uint8_t {
    kClosed = 0,     ///< nothing
    kContinued = 1,  ///< the next file of the same run
  };
  Cause cause = Cause::kClosed;
  Time time{};
  std::uint64_t tick = 0;  ///< number of the last tick
};

/// Gets a history in the order of happening. What is handed over is valid during the call only.
class HistoryHandler {
 public:
  virtual ~HistoryHandler() = default;
  virtual void OnTree(const TreeDescription& tree) = 0;
  virtual void OnState(const HistoryState& state) = 0;
  virtual void OnTick(const TickEvents& events) = 0;
  virtual void OnGap(const HistoryGap&) {}
  virtual void OnNote(const HistoryNote&) {}
  virtual void OnEnd(const HistoryEnd&) {}
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_HISTORY_H_
