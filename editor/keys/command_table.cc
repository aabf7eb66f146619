#include "editor/keys/command_table.h"

#include <stdexcept>
#include <utility>

namespace coppice::editor {

std::string EditorCommand::WhyNot() const {
  if (why_not) return why_not();
  return when && !when() ? "not for what is shown" : "";
}

void CommandTable::Add(EditorCommand command) {
  for (const EditorCommand& other : commands_) {
    if (other.id == command.id) throw std::invalid_argument("command twice: " + command.id);
    if (command.keys.key != 0 && other.keys == command.keys && !command.when && !other.when) {
      throw std::invalid_argument(ToString(command.keys) + " is bound to " + other.id + " and " +
                                  command.id);
    }
  }
  command.own_keys = command.keys;
  commands_.push_back(std::move(command));
}

bool CommandTable::SetKeys(std::string_view id, KeyChord keys) {
  for (EditorCommand& command : commands_) {
    if (command.id != id) continue;
    command.keys = keys;
    return true;
  }
  return false;
}

void CommandTable::AddKeys(std::string_view id, KeyChord keys) {
  for (EditorCommand& command : commands_) {
    if (command.id == id) command.also = keys;
  }
}

bool CommandTable::SetWhyNot(std::string_view id, std::function<std::string()> why_not) {
  for (EditorCommand& command : commands_) {
    if (command.id != id) continue;
    command.why_not = std::move(why_not);
    return true;
  }
  return false;
}

void CommandTable::ResetKeys() {
  for (EditorCommand& command : commands_) command.keys = command.own_keys;
}

std::vector<KeyConflict> CommandTable::FindConflicts() const {
  std::vector<KeyConflict> conflicts;
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const EditorCommand& a = commands_[i];
    for (std::size_t j = i + 1; a.keys.key != 0 && j < commands_.size(); ++j) {
      const EditorCommand& b = commands_[j];
      const bool at_the_same_time = !a.when == !b.when;
      const bool from_the_start = a.keys == a.own_keys && b.keys == b.own_keys;
      if (!(a.keys == b.keys) || !at_the_same_time || from_the_start) continue;
      conflicts.push_back({a.keys, a.id, b.id});
    }
  }
  return conflicts;
}

const EditorCommand* CommandTable::Find(std::string_view id) const {
  for (const EditorCommand& command : commands_) {
    if (command.id == id) return &command;
  }
  return nullptr;
}

bool CommandTable::Run(std::string_view id) const {
  const EditorCommand* command = Find(id);
  if (!command) return false;
  command->run();
  return true;
}

bool CommandTable::Press(KeyChord chord) const {
  if (chord.key == 0) return false;
  const EditorCommand* found = nullptr;
  for (const EditorCommand& command : commands_) {
    if (!(command.keys == chord)) continue;
    if (command.when ? command.when() : !found) found = &command;
  }
  for (const EditorCommand& command : commands_) {
    if (!found && command.also == chord) found = &command;
  }
  if (found) found->run();
  return found;
}

}  // namespace coppice::editor
