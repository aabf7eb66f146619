// Makes a history of what a robot with the Groot2 protocol answers to polls: transitions, statuses,
// blackboards. Knows no sockets.
//
// The protocol knows no ticks: transitions that follow each other within two milliseconds are taken
// for one. Their times are exact; values are as old as the poll that brought them.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HISTORY_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HISTORY_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "bt_core/engine/events/event_words.h"
#include "bt_core/engine/events/status_follower.h"
#include "bt_core/live/client/client_types.h"
#include "bt_core/live/groot2/client_robot_tree.h"

namespace coppice {

class Groot2History {
 public:
  static constexpr std::size_t kMostKeys = 65536;
  static constexpr std::size_t kMostNameBytes = 4 << 20;    ///< of keys, each with its board
  static constexpr std::size_t kMostValueBytes = 16 << 20;  ///< of all values: as long as an answer

  /// `endpoint`: for messages and as the name of the document.
  Groot2History(LiveListener& listener, std::string endpoint)
      : listener_(listener), endpoint_(std::move(endpoint)) {}

  // A problem is one of the robot's answer.

  /// The answer to FULLTREE: another tree. Nothing is told before the statuses have come.
  Outcome SetTree(const RunId& id, std::string xml);
  /// The answer to the start of a recording: microseconds since 1970 that transitions are counted
  /// from. Without it, statuses alone are used.
  Outcome SetRecording(std::string_view microseconds);
  Outcome AddTransitions(std::string_view bytes);
  Outcome AddStatuses(std::string_view bytes, Time now);
  /// Keeps the first kMostKeys keys with their values, as far as there is room for them.
  Outcome AddBoards(std::string_view message_pack, Time now);

  /// Of the present tree; zeros before the first.
  const RunId& id() const { return id_; }
  const RobotTree& tree() const { return tree_; }
  /// The tree and its state were told.
  bool has_begun() const { return follower_.has_value(); }

 private:
  struct Transition {
    Time time;
    NodeIndex node;
    Status status;
  };

  void Begin(const std::vector<Status>& statuses, Time now);
  void TellState(HistoryState::Cause cause, Time now);
  void TellTick(Time start, Duration duration);
  void TellLoss(const std::vector<Status>& statuses, Time now);
  void AddEvent(NodeIndex node, Status status);
  void Correct(const std::vector<Status>& statuses, Time now);
  std::optional<SlotIndex> SlotOf(const std::string& board, const std::string& key);
  bool SetValue(SlotIndex slot, std::string value);

  LiveListener& listener_;
  const std::string endpoint_;
  RunId id_{};
  RobotTree tree_;
  std::optional<Time> recording_;  // what transitions are counted from
  bool has_lost_ = false;          // transitions, since the last statuses
  std::optional<StatusFollower> follower_;
  std::vector<Status> shown_;                                      // in the last answer
  std::map<std::string, std::map<std::string, SlotIndex>> slots_;  // by board and key
  std::size_t name_bytes_ = 0;                                     // of all slots
  std::vector<std::string> values_;
  std::size_t value_bytes_ = 0;
  EventWriter words_;
  std::uint64_t tick_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HISTORY_H_
