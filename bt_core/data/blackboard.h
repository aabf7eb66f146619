// The blackboard: one flat array of typed slots. Names are resolved to slot numbers when a tree is
// loaded; ticking never looks up a name.
//
// A Layout is the immutable description (which scopes and keys there are, their types and first
// values); a Blackboard holds the values of one running tree. Each SubTree instance is a scope; a
// remapped key is the same slot under two names.
#ifndef COPPICE_BT_CORE_DATA_BLACKBOARD_H_
#define COPPICE_BT_CORE_DATA_BLACKBOARD_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/strong_index.h"
#include "bt_core/data/inbox.h"
#include "bt_core/data/value.h"

namespace coppice {

using ScopeIndex = StrongIndex<struct ScopeTag>;
inline constexpr ScopeIndex kMainScope{0};

struct Slot {
  Value value;               ///< empty until it is written for the first time
  Time stamp{};              ///< begin of the tick in which it was written last
  std::uint32_t writes = 0;  ///< counts every write
  std::uint32_t epoch = 0;   ///< mailboxes: of the message that lies here

  /// Whoever changes the value calls this, with Blackboard::now().
  void CountWrite(Time now) {
    ++writes;
    stamp = now;
  }
};

struct SlotDefinition {
  std::string key;             ///< empty for literals and mailboxes
  ScopeIndex scope{0};         ///< where the key was first named
  const Type* type = nullptr;  ///< of all ports that share this slot
  Value initial;               ///< a literal, or empty
};

struct Layout {
  std::vector<std::string> scopes;  ///< instance path of each scope; the root's is its tree ID
  std::vector<SlotDefinition> slots;

  /// The slot that a key names in a scope where it was first used, or kNoSlot. For wiring and
  /// inspection.
  SlotIndex Find(ScopeIndex scope, std::string_view key) const;
};

/// The values of one running tree, by the number of their slot.
class Blackboard {
 public:
  Blackboard() = default;
  explicit Blackboard(std::size_t size) : slots_(size) {}

  Slot& operator[](SlotIndex index) { return slots_[index]; }
  const Slot& operator[](SlotIndex index) const { return slots_[index]; }
  std::size_t size() const { return slots_.size(); }
  /// Pointers to slots become invalid.
  void resize(std::size_t size) { slots_.resize(size); }
  Slot* data() { return slots_.data(); }
  const Slot* data() const { return slots_.data(); }
  std::vector<Slot>::const_iterator begin() const { return slots_.begin(); }
  std::vector<Slot>::const_iterator end() const { return slots_.end(); }

  /// When the present tick began. The reference stays valid as long as the blackboard.
  const Time& now() const { return now_; }
  void set_now(Time now) { now_ = now; }

 private:
  std::vector<Slot> slots_;
  Time now_{};
};

/// All slots with their first values.
Blackboard MakeBlackboard(const Layout& layout);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_BLACKBOARD_H_
