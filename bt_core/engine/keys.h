// While a tree is compiled: which slot a key names in which scope, and of what type it is.
//
// Each SubTree instance is a scope. A key of a scope is a slot of its own, unless an attribute of
// the SubTree or _autoremap makes it the slot of a key outside. "@key" is a key of the main tree.
#ifndef COPPICE_BT_CORE_ENGINE_KEYS_H_
#define COPPICE_BT_CORE_ENGINE_KEYS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bt_core/data/blackboard.h"
#include "bt_core/engine/registry.h"
#include "bt_core/model/document.h"

namespace coppice {

/// The key that the text of an attribute names: "{goal}" is "goal", "=" and "{=}" are `own_name`.
/// Empty for a literal.
std::string_view KeyOf(std::string_view text, std::string_view own_name);

class KeyTable {
 public:
  /// Slots go to the layout, clashes of types to the diagnostics. The documents given to the
  /// functions below must outlive the table.
  KeyTable(Layout& layout, Diagnostics& diagnostics) : layout_(layout), diagnostics_(diagnostics) {}

  /// Scope 0 is that of the main tree. With `autoremap` it has the keys of its parent, but for
  /// those that begin with an underscore.
  ScopeIndex AddScope(ScopeIndex parent, bool autoremap);

  /// A slot with or without a key; literals and mailboxes have none.
  SlotIndex AddSlot(std::string key, ScopeIndex scope, const Type* type);

  /// The slot of a key, made if this is its first use.
  SlotIndex Resolve(std::string_view key, ScopeIndex scope);

  /// Gives a slot the type of a port; an error if another port has given it another type. `offset`
  /// is where the key is written.
  void SetType(SlotIndex slot, const Registry::Entry& entry, const PortDeclaration& port,
               const Document& document, std::uint32_t offset);

  /// The attributes of a SubTree: each makes a key of the inner scope a key of the outer one, or a
  /// literal.
  void Remap(const Document& document, const Element& element, ScopeIndex outer, ScopeIndex inner);

  /// At the end, when the types of all ports are known: converts the literals that were given to
  /// SubTrees. What no port reads is a string.
  void ConvertLiterals();

 private:
  struct Scope {
    std::unordered_map<std::string_view, SlotIndex> keys;
    ScopeIndex parent;
    bool autoremap;
  };
  struct Literal {
    SlotIndex slot;
    const Document* document;
    const Attribute* attribute;
  };

  Layout& layout_;
  Diagnostics& diagnostics_;
  std::vector<Scope> scopes_;
  std::vector<Literal> literals_;
  // Per slot the port that gave it its type; for messages.
  std::unordered_map<SlotIndex, std::pair<const Registry::Entry*, const PortDeclaration*>>
      first_use_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_KEYS_H_
