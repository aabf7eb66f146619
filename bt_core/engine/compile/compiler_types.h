// The types of slots, found out from all who use them, and the literals that get these types.
//
// A port of a node's C++ class gives its slot a type; two ports that disagree are an error, through
// every SubTree boundary, because a remapped key is the same slot. A slot that no port types takes
// values of any type.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_TYPES_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_TYPES_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "bt_core/data/blackboard.h"
#include "bt_core/data/port.h"
#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/model/document.h"

namespace coppice {

/// A place in a file; it must outlive what keeps it.
struct DocumentPlace {
  const Document* document;
  std::uint32_t offset;
};

class SlotTypes {
 public:
  /// The texts given to the functions below must outlive the table.
  SlotTypes(Layout& layout, Problems& problems) : layout_(layout), problems_(problems) {}

  /// Null if no port gives it one.
  const Type* Of(SlotIndex slot) const { return layout_.slots[slot].type; }

  /// The slot gets the type of a port of node type `owner`. A port that takes any type changes
  /// nothing. `may_convert`: an input of another type that reads a text is a warning only.
  void Set(SlotIndex slot, std::string_view owner, const PortDeclaration& port, DocumentPlace place,
           bool may_convert = false);

  /// A port of a node that converts names the slot: it needs no value to be assigned to.
  void Declare(SlotIndex slot) { declared_.insert(slot); }
  bool IsDeclared(SlotIndex slot) const { return declared_.count(slot) > 0; }

  /// The type that a model of a SubTree names for a slot. It counts if no port gives it one, and is
  /// a warning if a port gives it another one. Numbers of all sorts are the same to a model.
  void Suggest(SlotIndex slot, const Type& type, DocumentPlace place);

  /// A node of type `owner` copies what is in `from`, whatever it is, to `to`: if ports give a type
  /// to `to`, then `from` has it, too.
  void AddCopy(SlotIndex from, SlotIndex to, std::string_view owner, DocumentPlace place);

  /// The text will be the first value of the slot. `name` says in messages what it is given to.
  void AddLiteral(SlotIndex slot, std::string_view text, std::string name, DocumentPlace place);

  /// When all ports are bound: settles the types and gives them to the literals. In a slot without
  /// type the text decides (bt_core/data/literal.h).
  void Settle();

 private:
  struct FirstUse {
    std::string_view owner;
    std::string_view port;
  };
  struct Suggestion {
    SlotIndex slot;
    const Type* type;
    DocumentPlace place;
  };
  struct Copy {
    SlotIndex from;
    SlotIndex to;
    std::string_view owner;
    DocumentPlace place;
  };
  struct Literal {
    SlotIndex slot;
    std::string_view text;
    std::string name;
    DocumentPlace place;
  };

  void Settle(const Suggestion& suggestion);
  void SpreadAgainstCopies();
  void Check(const Copy& copy);
  void Convert(const Literal& literal);

  Layout& layout_;
  Problems& problems_;
  std::unordered_map<SlotIndex, FirstUse> first_use_;  // what gave a slot its type; for messages
  std::unordered_set<SlotIndex> declared_;
  std::vector<Suggestion> suggestions_;
  std::vector<Copy> copies_;
  std::vector<Literal> literals_;
};

/// What a text should have been: "expected int", "expected RED, GREEN or BLUE".
std::string ExpectedText(const Type& type);

/// Its texts are elements with semicolons between them.
bool IsList(const Type& type);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_TYPES_H_
