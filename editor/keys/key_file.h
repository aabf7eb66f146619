// The user's own keys, as a text of lines:
//
//   # comment
//   view.fit_all = Ctrl+Home
//   tree.collapse =              (no key)
//
// What a command has is said by "F1", with its ID. A line that cannot be right is said, with its
// number; the others hold.
#ifndef COPPICE_EDITOR_KEYS_KEY_FILE_H_
#define COPPICE_EDITOR_KEYS_KEY_FILE_H_

#include <string>
#include <string_view>

#include "bt_core/base/diagnostic.h"
#include "editor/keys/command_table.h"

namespace coppice::editor {

/// Gives the commands the keys that the text says; those it does not name keep theirs. `file` is
/// for the messages.
void ReadKeys(std::string_view text, const std::string& file, CommandTable& commands,
              Diagnostics& diagnostics);

/// The text in which the command has these keys; comments and other lines stay as they are. Without
/// keys the line says that it has none.
std::string WithKeys(std::string_view text, std::string_view id, KeyChord keys);

/// The text without a line for the command, which then has its own keys.
std::string WithoutKeys(std::string_view text, std::string_view id);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_KEY_FILE_H_
