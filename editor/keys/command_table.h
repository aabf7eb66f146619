// Every command of the editor by ID, with its title and its key. Menus, keys and the command
// palette all run commands from here, so that nothing can be done in one way only.
#ifndef COPPICE_EDITOR_KEYS_COMMAND_TABLE_H_
#define COPPICE_EDITOR_KEYS_COMMAND_TABLE_H_

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/keys/keys.h"

namespace coppice::editor {

struct EditorCommand {
  std::string id;     ///< "view.fit_all"
  std::string title;  ///< "Fit all"
  KeyChord keys;
  std::function<void()> run;
  /// Whether its keys are its own now, before those of commands without it; null: always.
  std::function<bool()> when = nullptr;
  KeyChord own_keys = {};  ///< those it was added with; set by Add
  /// Of a switch: whether it is on; null: it is none.
  std::function<bool()> is_on = nullptr;
  /// Why it cannot be done now, or an empty text; null: nobody asked that yet.
  std::function<std::string()> why_not = nullptr;
  KeyChord also = {};  ///< other keys that people know it by; they hold where no command has them

  /// Why it cannot be done now; empty: it can.
  std::string WhyNot() const;
};

/// Two commands whose keys are their own at the same time, because the user has said so.
struct KeyConflict {
  KeyChord keys;
  std::string first;  ///< IDs
  std::string second;
};

class CommandTable {
 public:
  /// Throws std::invalid_argument if the ID is taken, or the keys by another command that has them
  /// always.
  void Add(EditorCommand command);

  /// Gives the command of that ID other keys, or none (key 0). False if there is no such
  /// command.
  bool SetKeys(std::string_view id, KeyChord keys);
  /// All commands have the keys again that they were added with.
  void ResetKeys();
  std::vector<KeyConflict> FindConflicts() const;

  const std::vector<EditorCommand>& all() const { return commands_; }

  /// The command of that ID, or null.
  const EditorCommand* Find(std::string_view id) const;

  /// Runs the command of that ID; false if there is none.
  bool Run(std::string_view id) const;

  /// The command of that ID cannot be done while that says why. False if there is no such command.
  bool SetWhyNot(std::string_view id, std::function<std::string()> why_not);

  /// The command has these keys also.
  void AddKeys(std::string_view id, KeyChord keys);

  /// Runs what the key is bound to; false if it is bound to nothing.
  bool Press(KeyChord chord) const;

 private:
  std::vector<EditorCommand> commands_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_COMMAND_TABLE_H_
