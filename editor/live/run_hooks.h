// Makes a robot have the hooks that a HookList wants: sets what is missing, removes what is wanted
// no more, and begins anew after a reconnection, since robots release what a lost client held.
#ifndef COPPICE_EDITOR_LIVE_RUN_HOOKS_H_
#define COPPICE_EDITOR_LIVE_RUN_HOOKS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "editor/live/hook_list.h"
#include "editor/live/run_source.h"

namespace coppice::editor {

/// What became of a wanted hook on one robot.
struct SetHookState {
  HookId id = kNoHook;     ///< on the robot; kNoHook: not set (yet)
  bool is_asked = false;   ///< the robot has been asked to set it
  std::uint32_t hits = 0;  ///< how often it acted
  std::string remark;      ///< why it is not set, or what the robot says to it
};

class RunHooks {
 public:
  explicit RunHooks(RunSource& source) : source_(source) {}

  /// Once per frame, while the robot answers.
  void Sync(const HookList& wanted);
  /// The connection is gone, and all hooks with it.
  void Forget();
  void OnNotice(const LiveNotice& notice);

  /// By WantedHook::number; null if the robot has never heard of it.
  const SetHookState* Find(std::uint32_t number) const;
  /// The wanted hook that the robot knows by that number; 0: none of ours.
  std::uint32_t NumberOf(HookId id) const;

 private:
  using Hooks = std::map<std::uint32_t, SetHookState>;

  void Set(const WantedHook& wanted);
  void Remove(HookId id) const;

  RunSource& source_;
  // Replies come when they come: they hold on to what they are about.
  std::shared_ptr<Hooks> hooks_ = std::make_shared<Hooks>();
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_HOOKS_H_
