// The hooks of a debugger, found by node. Not thread-safe; the debugger has a lock.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_HOOK_TABLE_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_HOOK_TABLE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "bt_core/engine/program.h"
#include "bt_core/live/debug/debugger_hooks.h"

namespace coppice {

class HookTable {
 public:
  /// More hooks are refused.
  static constexpr std::size_t kMaxHooks = 4096;
  static constexpr std::size_t kMaxTextBytes = 1 << 20;  ///< of their paths and conditions
  static constexpr std::size_t kMaxPlaces = 2'000'000;   ///< nodes of all hooks together

  /// A node that is delayed now.
  struct Delayed {
    NodeIndex node;
    Time until;
  };

  struct Entry {
    HookInfo info;
    std::optional<Script> condition;  ///< of the present program
    std::vector<Delayed> delayed;
  };

  explicit HookTable(std::shared_ptr<const Program> program) : program_(std::move(program)) {}

  Expected<HookAnswer> Add(const Hook& hook, OwnerId owner);
  Expected<HookAnswer> Change(HookId id, const Hook& hook);
  bool Remove(HookId id);

  /// Searches another program for the nodes of all hooks.
  void SetProgram(std::shared_ptr<const Program> program);

  /// Null if there is none; valid until hooks come or go.
  const Entry* Find(HookId id) const;
  Entry* Find(HookId id) { return const_cast<Entry*>(std::as_const(*this).Find(id)); }
  const std::vector<Entry>& entries() const { return entries_; }
  std::vector<HookId> IdsOf(OwnerId owner) const;

  /// The enabled hooks at a node: first those that stop, then those that decide.
  std::vector<HookId> At(NodeIndex node, HookPosition position) const;
  /// The nodes that have hooks, in ascending order.
  std::vector<NodeIndex> Nodes() const;

  const std::shared_ptr<const Program>& program() const { return program_; }

 private:
  Outcome Check(const Hook& hook) const;
  Outcome CheckRoom(const Entry& entry) const;
  Expected<HookAnswer> Resolve(Entry& entry) const;
  void RebuildPlaces();

  std::shared_ptr<const Program> program_;
  std::vector<Entry> entries_;                        // by ascending id
  std::vector<std::pair<NodeIndex, HookId>> places_;  // in ascending order
  HookId last_id_ = kNoHook;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_HOOK_TABLE_H_
