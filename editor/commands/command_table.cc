#include "editor/commands/command_table.h"

#include <stdexcept>
#include <utility>

namespace coppice::editor {

void CommandTable::Add(Command command) {
  for (const Command& other : commands_) {
    if (other.id == command.id) throw std::invalid_argument("command twice: " + command.id);
    if (command.keys.key != 0 && other.keys == command.keys && !command.when && !other.when) {
      throw std::invalid_argument(ToString(command.keys) + " is bound to " + other.id + " and " +
                                  command.id);
    }
  }
  commands_.push_back(std::move(command));
}

const Command* CommandTable::Find(std::string_view id) const {
  for (const Command& command : commands_) {
    if (command.id == id) return &command;
  }
  return nullptr;
}

bool CommandTable::Run(std::string_view id) const {
  const Command* command = Find(id);
  if (!command) return false;
  command->run();
  return true;
}

bool CommandTable::Press(KeyChord chord) const {
  if (chord.key == 0) return false;
  const Command* found = nullptr;
  for (const Command& command : commands_) {
    if (!(command.keys == chord)) continue;
    if (command.when ? command.when() : !found) found = &command;
  }
  if (found) found->run();
  return found;
}

}  // namespace coppice::editor
