#include "editor/live/run_hooks.h"

#include <utility>

namespace coppice::editor {

void RunHooks::Sync(const HookList& wanted) {
  for (auto at = hooks_->begin(); at != hooks_->end();) {
    const WantedHook* hook = wanted.Find(at->first);
    const bool is_wanted = hook && hook->hook.enabled;
    if (is_wanted || (at->second.is_asked && at->second.id == kNoHook &&
                      at->second.remark.empty())) {  // the answer is still to come
      ++at;
      continue;
    }
    if (at->second.id != kNoHook) Remove(at->second.id);
    at = hooks_->erase(at);
  }
  for (const WantedHook& hook : wanted.all()) {
    const bool is_meant = hook.robot.empty() || hook.robot == source_.name();
    if (is_meant && hook.hook.enabled && !(*hooks_)[hook.number].is_asked) Set(hook);
  }
}

void RunHooks::Set(const WantedHook& wanted) {
  (*hooks_)[wanted.number].is_asked = true;
  const std::uint32_t number = wanted.number;
  source_.Send(SetHook(wanted.hook), [hooks = hooks_, number](const LiveReply& reply) {
    const auto at = hooks->find(number);
    if (at == hooks->end()) return;
    at->second.id = reply ? reply->id : kNoHook;
    at->second.remark = reply ? reply->remark : reply.problem();
  });
}

void RunHooks::Remove(HookId id) const {
  LiveCommand command = MakeCommand(LiveCommand::Kind::kRemoveHook);
  command.id = id;
  source_.Send(std::move(command), nullptr);
}

void RunHooks::Forget() { hooks_ = std::make_shared<Hooks>(); }

void RunHooks::OnNotice(const LiveNotice& notice) {
  const bool acted = notice.event.kind == DebugEvent::Kind::kStopped ||
                     notice.event.kind == DebugEvent::Kind::kReplaced;
  const std::uint32_t number = NumberOf(notice.event.stop.hook);
  if (acted && number != 0) ++(*hooks_)[number].hits;
}

const SetHookState* RunHooks::Find(std::uint32_t number) const {
  const auto at = hooks_->find(number);
  return at == hooks_->end() ? nullptr : &at->second;
}

std::uint32_t RunHooks::NumberOf(HookId id) const {
  if (id == kNoHook) return 0;
  for (const auto& [number, hook] : *hooks_) {
    if (hook.id == id) return number;
  }
  return 0;
}

}  // namespace coppice::editor
