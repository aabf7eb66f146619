// What `coppice live` knows of a robot at one moment, for drawing it.
#ifndef COPPICE_BT_CORE_CLI_LIVE_LIVE_SCENE_H_
#define COPPICE_BT_CORE_CLI_LIVE_LIVE_SCENE_H_

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/frames/run_follower.h"
#include "bt_core/live/client/client.h"

namespace coppice {

struct LiveScene {
  LiveConnection connection;
  RunFollower run;
  Status result = Status::kIdle;  ///< of the last tick
  Duration duration{0};           ///< that it took
  std::uint64_t lost_ticks = 0;
  std::vector<ForeignHook> foreign_hooks;
  std::string stop;               ///< where the tree stands, for people; empty: it goes on
  std::deque<std::string> texts;  ///< what nodes and debugger said last
  std::uint64_t changes = 0;      ///< of anything that is seen
};

/// Keeps a scene up to date.
class LiveSceneKeeper : public LiveListener {
 public:
  /// Any thread. Waits until something has changed since `changes`, at most so long; false if
  /// nothing has.
  bool Wait(std::uint64_t changes, Duration at_most);

  /// Any thread. `use` gets the scene and must be quick.
  template <class Use>
  auto Look(const Use& use) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return use(scene_);
  }

  /// Any thread. Shows a line below the tree.
  void Say(std::string text);

  void OnConnection(const LiveConnection& connection) override;
  void OnTree(const TreeDescription& tree) override;
  void OnState(const HistoryState& state) override;
  void OnTick(const TickEvents& events) override;
  void OnGap(const HistoryGap& gap) override;
  void OnNotice(const LiveNotice& notice) override;
  void OnForeignHooks(const std::vector<ForeignHook>& hooks) override;

 private:
  void AddText(std::string text);
  void Changed();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  LiveScene scene_;
};

/// What the robot's debugger has told, for people.
std::string Describe(const LiveNotice& notice);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_LIVE_SCENE_H_
