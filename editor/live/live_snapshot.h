// What is known of a robot at one moment. Immutable once published, so the frame and the client's
// thread share it without a lock.
#ifndef COPPICE_EDITOR_LIVE_LIVE_SNAPSHOT_H_
#define COPPICE_EDITOR_LIVE_LIVE_SNAPSHOT_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "editor/live/protocol.h"
#include "editor/scene/forest.h"

namespace coppice::editor {

/// The tree that a robot runs. Another id, another object.
struct LiveTree {
  TreeId id{};
  Forest forest;
  Diagnostics problems;  ///< of its text
};

struct NodeState {
  Status status = Status::kIdle;
  Status before = Status::kIdle;  ///< of an idle node: its last status
  Time since{0};                  ///< when the editor saw the status come
};

enum class Connection : std::uint8_t { kConnecting, kLive, kReconnecting };

/// "connecting", "live", "reconnecting".
const char* ToString(Connection connection);

struct LiveSnapshot {
  Connection connection = Connection::kConnecting;
  std::string error;  ///< why it is not live; empty if it is
  Duration round_trip{0};
  double rate = 0;                       ///< status answers per second
  int sessions = 0;                      ///< trees seen so far
  Time next_try{0};                      ///< when reconnecting
  std::shared_ptr<const LiveTree> tree;  ///< the last known one; null before the first
  std::vector<NodeState> states;         ///< by uid
  std::vector<Board> boards;             ///< those asked for
};

/// Where the editor gets a robot's snapshots from.
class LiveSource {
 public:
  virtual ~LiveSource() = default;

  /// "127.0.0.1:1667"; the robot's name in the editor.
  virtual const std::string& endpoint() const = 0;

  /// The newest one, never null. Any thread.
  virtual std::shared_ptr<const LiveSnapshot> snapshot() const = 0;

  /// The blackboards to ask for from now on. Any thread.
  virtual void Watch(std::vector<std::string> boards) = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_LIVE_SNAPSHOT_H_
