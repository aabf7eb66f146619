// Every place in a document where a blackboard key is named: in ports, in attributes of SubTrees
// and in scripts. For what the scene shows see scene/key_uses.h; this is for changing them.
//
//   for (const KeyName& name : KeyNamesIn(document, models, tree)) { /* name.key, name.begin */ }
//
// What counts as a key is the engine's rule (bt_core/model/keys.h, docs/scripts.md).
#ifndef COPPICE_EDITOR_DOCUMENT_KEY_NAMES_H_
#define COPPICE_EDITOR_DOCUMENT_KEY_NAMES_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/model/document.h"
#include "editor/scene/node_models.h"

namespace coppice::editor {

enum class KeyForm : std::uint8_t {
  kBraces,  ///< goal="{key}", or goal="{=}": the key has the name of the port
  kPlain,   ///< output_key="key", and of a SubTree in format 3: goal="key"
  kScript   ///< a word of a script
};

struct KeyName {
  std::string key;  ///< without '@'
  bool is_global = false;
  KeyForm form = KeyForm::kBraces;
  bool reads = false;
  bool writes = false;   ///< neither reads nor writes: a SubTree that hands the key on
  bool guessed = false;  ///< no model describes the port: it may write the key as well
  ElementIndex element{0};
  std::string_view attribute;
  std::uint32_t begin = 0;  ///< bytes of the text: the whole value, or the word in a script
  std::uint32_t end = 0;
};

/// Those of the element and all that is in it, in document order. Words in capitals that no script
/// assigns are taken for the names of an enum. A port
/// that no model describes is taken for an input.
std::vector<KeyName> KeyNamesIn(const Document& document, const NodeModels& models,
                                ElementIndex branch);

/// The key that an attribute hands on; empty if it is a literal. A <SubTree> of format 3 names it
/// without braces.
std::string_view KeyHandedOn(const Element& element, const Attribute& attribute, bool is_format_3);

/// Names another key in that place; `key` may begin with '@'.
Splice WithKey(const KeyName& name, std::string_view key);

/// True for what the engine takes for a key: letters, digits, '_' and some more, not empty.
bool IsKeyName(std::string_view text);

/// One past the last element that lies in it.
ElementIndex EndOfBranch(const Document& document, ElementIndex element);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_KEY_NAMES_H_
