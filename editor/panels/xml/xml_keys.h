// The keys of the XML tile while the user types in it.
#ifndef COPPICE_EDITOR_PANELS_XML_XML_KEYS_H_
#define COPPICE_EDITOR_PANELS_XML_XML_KEYS_H_

#include <functional>
#include <string>

#include "editor/document/text_edit.h"
#include "editor/keys/keys.h"

namespace coppice::editor {

struct TextClipboard {
  std::function<std::string()> get;
  std::function<void(const std::string&)> set;
};

/// True for keys that move, delete, select or write; all others are those of the commands.
bool IsTextKey(KeyChord chord);

/// Does what the key means. Characters come on their own.
void PressTextKey(KeyChord chord, const TextClipboard& clipboard, TextEdit& edit);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_XML_XML_KEYS_H_
