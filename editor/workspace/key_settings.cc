#include "editor/workspace/key_settings.h"

#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"
#include "editor/keys/key_file.h"

namespace coppice::editor {
namespace {

std::string ReadFileOf(const KeySettings& settings) { return ReadFile(settings.file).value_or(""); }

// Reads it again, so that what is said of it is true.
void Keep(EditorState& state, const std::string& text, double now) {
  KeySettings& settings = state.key_settings;
  settings.problems = {};
  if (!settings.file.empty()) {
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(settings.file).parent_path(), error);
    Diagnostics wrong;
    if (!WriteFile(settings.file, text, wrong)) {
      state.Notify(ToString(wrong.all().front()), now, true);
    }
  }
  state.commands.ResetKeys();
  ReadKeys(text, settings.file, state.commands, settings.problems);
}

}  // namespace

const EditorCommand* OtherWithKeys(const EditorState& state, const EditorCommand& command,
                                   KeyChord keys) {
  if (keys.key == 0) return nullptr;
  for (const EditorCommand& other : state.commands.all()) {
    const bool at_the_same_time = !other.when == !command.when;
    if (&other != &command && other.keys == keys && at_the_same_time) return &other;
  }
  return nullptr;
}

void GiveKeys(EditorState& state, const std::string& id, KeyChord keys, double now) {
  const EditorCommand* command = state.commands.Find(id);
  if (!command) return;
  std::string text = ReadFileOf(state.key_settings);
  while (const EditorCommand* other = OtherWithKeys(state, *command, keys)) {
    text = WithKeys(text, other->id, {});
    state.commands.SetKeys(other->id, {});
  }
  text = WithKeys(text, id, keys);
  Keep(state, text, now);
}

void GiveOwnKeys(EditorState& state, const std::string& id, double now) {
  Keep(state, WithoutKeys(ReadFileOf(state.key_settings), id), now);
}

}  // namespace coppice::editor
