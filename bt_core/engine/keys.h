// While a tree is compiled: which slot a key names in which scope, and of what type it is.
//
// Each SubTree instance is a scope. A key of a scope is a slot of its own, unless an attribute of
// the SubTree or _autoremap makes it the slot of a key outside. "@key" is a key of the main tree.
#ifndef COPPICE_BT_CORE_ENGINE_KEYS_H_
#define COPPICE_BT_CORE_ENGINE_KEYS_H_

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bt_core/data/blackboard.h"
#include "bt_core/data/port.h"
#include "bt_core/engine/compiler_problems.h"
#include "bt_core/model/document.h"

namespace coppice {

/// The key that the text of an attribute names: "{goal}" is "goal", "=" and "{=}" are `own_name`.
/// Empty for a literal, such as "goal_{x}": a key is the whole text or none of it.
std::string_view KeyOf(std::string_view text, std::string_view own_name);

class KeyTable {
 public:
  /// Slots go to the layout. The documents and texts given to the functions below must outlive the
  /// table.
  KeyTable(Layout& layout, Problems& problems) : layout_(layout), problems_(problems) {}

  /// Scope 0 is that of the main tree. With `autoremap` it has the keys of its parent, but for
  /// those that begin with an underscore.
  ScopeIndex AddScope(ScopeIndex parent, bool autoremap);

  /// A slot with or without a key; the literals of ports and mailboxes have none.
  SlotIndex AddSlot(std::string key, ScopeIndex scope, const Type* type, Value initial = {});

  /// The slot of a key, made if this is its first use.
  SlotIndex Resolve(std::string_view key, ScopeIndex scope);

  /// The same for a key whose text does not outlive the table.
  SlotIndex ResolveCopy(std::string_view key, ScopeIndex scope);

  /// Makes the key of a scope that slot. Without effect if the scope has that key already.
  void Bind(std::string_view key, ScopeIndex scope, SlotIndex slot);

  /// The type that ports give to a slot; null if none does.
  const Type* TypeOf(SlotIndex slot) const { return layout_.slots[slot].type; }

  /// Gives a slot the type of a port; an error if another port has given it another type. A port
  /// that takes any type changes nothing. `offset` is where the key is written.
  void SetType(SlotIndex slot, std::string_view owner, const PortDeclaration& port,
               const Document& document, std::uint32_t offset);

  /// The text will be the first value of the slot, once the types of all ports are known.
  void AddLiteral(SlotIndex slot, std::string_view text, const Document& document,
                  std::uint32_t offset);

  /// At the end: gives the literals the types of their slots. In a slot without type the text
  /// decides (bt_core/data/literal.h).
  void ConvertLiterals();

 private:
  struct Scope {
    std::unordered_map<std::string_view, SlotIndex> keys;
    ScopeIndex parent;
    bool autoremap;
  };
  struct Literal {
    SlotIndex slot;
    std::string_view text;
    const Document* document;
    std::uint32_t offset;
  };
  struct FirstUse {
    std::string_view owner;
    std::string_view port;
  };

  // The scope whose own key it is.
  ScopeIndex Home(std::string_view key, ScopeIndex scope) const;

  Layout& layout_;
  Problems& problems_;
  std::vector<Scope> scopes_;
  std::vector<Literal> literals_;
  std::deque<std::string> copies_;
  std::unordered_map<SlotIndex, FirstUse> first_use_;  // what gave a slot its type; for messages
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_KEYS_H_
