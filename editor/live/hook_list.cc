#include "editor/live/hook_list.h"

#include <algorithm>
#include <utility>

namespace coppice::editor {

const WantedHook* HookList::Find(std::uint32_t number) const {
  const auto at = std::find_if(all_.begin(), all_.end(),
                               [number](const WantedHook& w) { return w.number == number; });
  return at == all_.end() ? nullptr : &*at;
}

const WantedHook* HookList::FindAt(const std::string& robot, const std::string& path,
                                   bool is_breakpoint) const {
  const auto at = std::find_if(all_.begin(), all_.end(), [&](const WantedHook& wanted) {
    return (wanted.robot.empty() || wanted.robot == robot) && wanted.hook.path == path &&
           IsBreakpoint(wanted.hook) == is_breakpoint;
  });
  return at == all_.end() ? nullptr : &*at;
}

void HookList::Add(std::string robot, Hook hook) {
  all_.push_back({++last_number_, std::move(robot), std::move(hook)});
}

void HookList::Remove(std::uint32_t number) {
  all_.erase(std::remove_if(all_.begin(), all_.end(),
                            [number](const WantedHook& w) { return w.number == number; }),
             all_.end());
}

void HookList::Change(std::uint32_t number, Hook hook) {
  for (WantedHook& wanted : all_) {
    if (wanted.number != number) continue;
    wanted.number = ++last_number_;
    wanted.hook = std::move(hook);
    return;
  }
}

void HookList::RemoveFaults() {
  all_.erase(std::remove_if(all_.begin(), all_.end(),
                            [](const WantedHook& w) { return !IsBreakpoint(w.hook); }),
             all_.end());
}

bool HookList::has_faults() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const WantedHook& w) { return !IsBreakpoint(w.hook) && w.hook.enabled; });
}

}  // namespace coppice::editor
