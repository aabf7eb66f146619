#include "bt_core/live/debug/debugger.h"

#include <utility>

#include "bt_core/live/debug/debugger_core.h"

namespace coppice {

Debugger::Debugger(Executor& executor, DebuggerOptions options)
    : core_(std::make_shared<Core>(executor, std::move(options))), inbox_(executor.inbox()) {}

// The executor knows the core until the ticking thread has run the call; without a ticking thread
// the call is never run, and goes with the inbox.
Debugger::~Debugger() {
  core_->Close();
  inbox_->PostCall([core = core_] { core->Detach(); });
}

Expected<HookAnswer> Debugger::Add(const Hook& hook, OwnerId owner) {
  return core_->Add(hook, owner);
}
Expected<HookAnswer> Debugger::Change(HookId id, const Hook& hook) {
  return core_->Change(id, hook);
}
bool Debugger::Remove(HookId id) { return core_->Remove(id); }
bool Debugger::SetEnabled(HookId id, bool enabled) { return core_->SetEnabled(id, enabled); }
void Debugger::RemoveAllOf(OwnerId owner) { core_->RemoveAllOf(owner); }
void Debugger::SetAllEnabledOf(OwnerId owner, bool enabled) {
  core_->SetAllEnabledOf(owner, enabled);
}
void Debugger::Release(OwnerId owner) { core_->Release(owner); }
void Debugger::ReleaseAll() { core_->Close(); }
Outcome Debugger::Pause(OwnerId owner) { return core_->Pause(owner); }
Outcome Debugger::StepNode(OwnerId owner) { return core_->StepNode(owner); }
Outcome Debugger::StepTick(OwnerId owner) { return core_->StepTick(owner); }
void Debugger::Continue(std::optional<Status> result) { core_->Continue(result); }
std::vector<HookInfo> Debugger::hooks() const { return core_->hooks(); }
std::optional<HookInfo> Debugger::Find(HookId id) const { return core_->Find(id); }
DebugStop Debugger::where() const { return core_->where(); }
bool Debugger::is_pausing() const { return core_->is_pausing(); }

}  // namespace coppice
