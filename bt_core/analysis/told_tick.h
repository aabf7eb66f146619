// What happened in a tick, by name: for those who print, export or ask.
//
//   HistoryFollower follower(ShapeOf(tree), state);
//   const ToldTick tick = TellTick(tree, follower, events);    // each tick, in order
#ifndef COPPICE_BT_CORE_ANALYSIS_TOLD_TICK_H_
#define COPPICE_BT_CORE_ANALYSIS_TOLD_TICK_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/frames/follower.h"

namespace coppice {

/// What happened in a tick, by name.
struct ToldTick {
  struct Change {
    std::string node;
    Status from;
    Status to;
  };
  struct Write {
    std::string scope;
    std::string key;
    std::string value;   ///< bytes as in data/value_bytes.h
    std::string writer;  ///< path; empty: not known, or from outside
  };
  struct Message {
    std::string node;
    EventText kind;
    std::string text;  ///< of kInjected the status, if it is known
  };
  std::uint64_t number;
  Time time;
  Duration duration;
  Status result;
  bool is_whole;
  std::vector<Change> changes;
  std::vector<Write> writes;
  std::vector<Message> messages;

  bool is_empty() const { return changes.empty() && writes.empty() && messages.empty(); }
};

/// Takes the tick into `follower`. Of nodes that are not `wanted` nothing is told, and then no
/// writes either; empty: all are.
ToldTick TellTick(const TreeDescription& tree, HistoryFollower& follower, const TickEvents& events,
                  const std::vector<bool>& wanted = {});

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_TOLD_TICK_H_
