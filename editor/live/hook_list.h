// The breakpoints and faults that the user wants, for all robots. They are there before a robot is:
// RunHooks (run_hooks.h) sets them as soon as it can.
#ifndef COPPICE_EDITOR_LIVE_HOOK_LIST_H_
#define COPPICE_EDITOR_LIVE_HOOK_LIST_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/live/client/client_types.h"

namespace coppice::editor {

struct WantedHook {
  std::uint32_t number = 0;  ///< counts from 1; another one after every change
  std::string robot;         ///< name of a RunSource; empty: every robot
  Hook hook;                 ///< by its path
};

/// It stops the tree; else it is a fault.
inline bool IsBreakpoint(const Hook& hook) { return hook.action == HookAction::kStop; }

class HookList {
 public:
  const std::vector<WantedHook>& all() const { return all_; }
  const WantedHook* Find(std::uint32_t number) const;
  /// A breakpoint or else a fault of that robot, or of every robot, at a path; null: there is none.
  const WantedHook* FindAt(const std::string& robot, const std::string& path,
                           bool is_breakpoint) const;

  void Add(std::string robot, Hook hook);
  void Remove(std::uint32_t number);
  void Change(std::uint32_t number, Hook hook);
  void RemoveFaults();

  /// A fault is there that is to act.
  bool has_faults() const;

 private:
  std::vector<WantedHook> all_;
  std::uint32_t last_number_ = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_HOOK_LIST_H_
