// While a tree is compiled: which slot a key names in which scope.
//
// Each SubTree instance is a scope. A key of a scope is a slot of its own, unless an attribute of
// the SubTree or _autoremap makes it the slot of a key outside. "@key" is a key of the main tree.
// What counts as a key: bt_core/model/keys.h.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_KEYS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_KEYS_H_

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bt_core/data/blackboard.h"

namespace coppice {

class KeyTable {
 public:
  /// Slots go to the layout. The texts given to the functions below must outlive the table.
  explicit KeyTable(Layout& layout) : layout_(layout) {}

  /// "@key" is not a key of the main tree but one of its own, named so: see OuterKeys.
  void KeepOuterKeys() { keeps_outer_keys_ = true; }

  /// Scope 0 is that of the main tree. With `autoremap` it has the keys of its parent, but for
  /// those that begin with an underscore.
  ScopeIndex AddScope(ScopeIndex parent, bool autoremap);

  /// A slot with or without a key; the literals of ports and mailboxes have none.
  SlotIndex AddSlot(std::string key, ScopeIndex scope, const Type* type, Value initial = {});

  /// The slot of a key, made if this is its first use.
  SlotIndex Resolve(std::string_view key, ScopeIndex scope);

  /// The same for a key whose text does not outlive the table.
  SlotIndex ResolveCopy(std::string_view key, ScopeIndex scope);

  /// True if that is the name of a key already, in this scope or where the scope has it from.
  bool Has(std::string_view key, ScopeIndex scope) const;

  /// About what slots and keys take.
  std::size_t bytes() const { return bytes_; }

  /// Makes the key of a scope that slot. Without effect if the scope has that key already.
  void Bind(std::string_view key, ScopeIndex scope, SlotIndex slot);

 private:
  struct Scope {
    std::unordered_map<std::string_view, SlotIndex> keys;
    ScopeIndex parent;
    bool autoremap;
  };

  // The scope whose own key it is.
  ScopeIndex Home(std::string_view key, ScopeIndex scope) const;

  // A name in a scope.
  void Enter(std::string_view key, ScopeIndex scope, SlotIndex slot);

  Layout& layout_;
  std::size_t bytes_ = 0;
  std::vector<Scope> scopes_;
  bool keeps_outer_keys_ = false;
  std::deque<std::string> names_;  // what ResolveCopy has kept
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_KEYS_H_
