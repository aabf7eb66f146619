// What becomes of the exceptions of user nodes and scripts (ExceptionPolicy).
#include <exception>
#include <string>
#include <utility>

#include "bt_core/engine/executor.h"

namespace coppice {

// Called while an exception is being handled.
Status Executor::FailByException(NodeIndex node) {
  AddExceptionMessage(node);
  if (options_.on_exception == ExceptionPolicy::kFailNode) return Status::kFailure;
  if (options_.on_exception == ExceptionPolicy::kRethrow) thrown_ = std::current_exception();
  thrower_ = node;
  throw Abort();
}

void Executor::AddExceptionMessage(NodeIndex node) {
  try {
    throw;
  } catch (const Abort&) {
    throw;
  } catch (const UnsetInput& error) {
    reporter_.Text(node, EventText::kException, Describe(error, node));
  } catch (const std::exception& error) {
    reporter_.Text(node, EventText::kException, error.what());
  } catch (...) {
    reporter_.Text(node, EventText::kException, "threw something that is not a std::exception");
  }
}

// The tick was left in the midst of it: a node may run whose parent does not.
Status Executor::EndAborted() {
  for (NodeIndex i{0}; i < statuses_.size(); ++i) {
    const bool has_begun = statuses_[i] == Status::kRunning || Keeps(i);
    if (has_begun && IsUserNode(nodes_[i].type)) HaltUser(i);
    memory_[i] = 0;
    if (has_begun || statuses_[i] != Status::kIdle) MakeIdle(i);
    if (has_begun && IsGuarded(i)) RunHaltedHook(i);
  }
  CountKept();
  wake_at_ = kNever;
  tick_again_ = false;
  return Status::kFailure;
}

void Executor::Rethrow() {
  try {
    std::rethrow_exception(std::exchange(thrown_, nullptr));
  } catch (const std::exception& error) {
    std::throw_with_nested(TickError(thrower_, program_->Path(thrower_) + ": " + error.what()));
  } catch (...) {
    std::throw_with_nested(
        TickError(thrower_, program_->Path(thrower_) + ": not a std::exception"));
  }
}

// Which port it was is found only now, so that reading one costs nothing more.
std::string Executor::Describe(const UnsetInput& error, NodeIndex node) const {
  const Registry::Entry* entry = program_->info[node].entry;
  if (!error.slot || !entry) return error.what();
  const auto slot = static_cast<SlotIndex>(error.slot - blackboard_.data());
  const std::uint32_t first = program_->FirstPort(node);
  for (std::size_t k = 0; k < entry->declarations.size(); ++k) {
    if (program_->ports[first + k].slot != slot) continue;
    return "input \"" + entry->declarations[k].name + "\" has no value: nobody has written key \"" +
           program_->layout.slots[slot].key + "\" yet";
  }
  return error.what();
}

}  // namespace coppice
