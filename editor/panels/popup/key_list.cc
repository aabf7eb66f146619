#include "editor/panels/popup/key_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/keys/fuzzy.h"
#include "editor/panels/widgets/panel.h"
#include "editor/workspace/key_settings.h"

namespace coppice::editor {
namespace {

constexpr float kKeysWidth = 150;

bool IsPressed(const EditorState& state, Key key) {
  return std::any_of(state.input.keys.begin(), state.input.keys.end(),
                     [key](const KeyEvent& event) { return event.key == key; });
}

void AskForKeys(EditorState& state, const std::string& id) {
  state.key_settings.command = id;
  state.key_settings.taken = {};
  state.OpenPopup(Popup::kNewKeys);
}

void PaintCommand(const Ui& ui, const EditorCommand& command, const Box& box) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pad = 6 * ui.scale;
  const bool is_changed = !(command.keys == command.own_keys);
  const TextStyle keys{Face::kMono, 11, is_changed ? ui.palette.accent : ui.palette.text};
  const TextStyle dim{Face::kSans, 11, ui.palette.text_dim};
  const float left = box.min.x + kKeysWidth * ui.scale;
  ui.RowText(list, box.min + Point{pad, 0}, box.height(), ToString(command.keys), keys,
             left - box.min.x - 2 * pad);
  const std::string note = is_changed
                               ? command.id + ", originally " +
                                     (command.own_keys.key ? ToString(command.own_keys) : "no key")
                               : command.id;
  const float note_width = std::min(ui.Width(note, dim), box.width() * 0.45F);
  ui.RowText(list, {left, box.min.y}, box.height(), command.title,
             {Face::kSans, 12, ui.palette.text}, box.max.x - left - note_width - 3 * pad);
  ui.RowText(list, {box.max.x - note_width - pad, box.min.y}, box.height(), note, dim,
             note_width + 1);
}

void DrawProblems(const Ui& ui, const Diagnostics& problems) {
  for (const Diagnostic& problem : problems.all()) {
    const Row row = NextRow(ui, "popup/keys/problem", false);
    ui.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{6 * ui.scale, 0}, row.box.height(),
               ToString(problem), {Face::kSans, 12, ui.palette.error}, row.box.width() - 12);
  }
}

}  // namespace

std::vector<const EditorCommand*> FindCommands(const CommandTable& commands,
                                               const std::string& typed) {
  std::vector<std::pair<int, const EditorCommand*>> found;
  for (const EditorCommand& command : commands.all()) {
    const int score =
        std::max({FuzzyScore(typed, command.title), FuzzyScore(typed, ToString(command.keys)),
                  FuzzyScore(typed, command.id)});
    if (score > 0) found.emplace_back(score, &command);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const EditorCommand*> sorted;
  for (const auto& [score, command] : found) sorted.push_back(command);
  return sorted;
}

void DrawKeyList(const Ui& ui, EditorState& state) {
  const std::vector<const EditorCommand*> commands = FindCommands(state.commands, state.popup.text);
  const int count = static_cast<int>(commands.size());
  const int before = state.popup.choice;
  if (IsPressed(state, kKeyDown)) ++state.popup.choice;
  if (IsPressed(state, kKeyUp)) --state.popup.choice;
  state.popup.choice = std::clamp(state.popup.choice, 0, std::max(count - 1, 0));
  state.popup.rows = commands.size() + state.key_settings.problems.all().size();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::Dummy({1, 6 * ui.scale});
  DrawProblems(ui, state.key_settings.problems);
  const float row_height = kRowHeight * ui.scale;
  const float whole = std::floor(ImGui::GetContentRegionAvail().y / row_height) * row_height;
  ImGui::BeginChild("rows", {0, std::max(whole, row_height)}, false);
  const EditorCommand* chosen = nullptr;
  for (int i = 0; i < count; ++i) {
    const EditorCommand& command = *commands[static_cast<std::size_t>(i)];
    const Row row = NextRow(ui, "popup/keys/" + command.id, i == state.popup.choice);
    if (i == state.popup.choice && before != i) ImGui::SetScrollHereY();
    if (row.visible) PaintCommand(ui, command, row.box);
    if (row.clicked || (i == state.popup.choice && IsPressed(state, kKeyEnter))) chosen = &command;
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (chosen) AskForKeys(state, chosen->id);
}

void DrawNewKeys(const Ui& ui, EditorState& state) {
  KeySettings& settings = state.key_settings;
  const EditorCommand* command = state.commands.Find(settings.command);
  if (!command) return;
  const bool is_first_frame = std::exchange(state.popup.is_new, false);
  const auto write = [&](const char* path, const std::string& text, Color color) {
    const Row row = NextRow(ui, path, false);
    ui.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{6 * ui.scale, 0}, row.box.height(),
               text, {Face::kSans, 12, color}, row.box.width() - 12);
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  const EditorCommand* other = OtherWithKeys(state, *command, settings.taken);
  const std::string now =
      command->keys.key ? "now " + ToString(command->keys) : std::string("has no key now");
  write("popup/new_keys", "Press the keys of \"" + command->title + "\" (" + now + ")",
        ui.palette.text);
  write("popup/help", "Del: no key     Backspace: the original key     Esc: leave it",
        ui.palette.text_dim);
  write("popup/taken",
        other ? ToString(settings.taken) + " is \"" + other->title + "\"; press it again to take it"
              : "",
        ui.palette.warning);
  ImGui::PopStyleVar();
  if (is_first_frame) return;
  for (const KeyEvent& event : state.input.keys) {
    const KeyChord pressed = {event.key, event.modifiers};
    if (event.key >= kKeyLeftShift || event.key == kKeyEscape) continue;
    if (pressed == KeyChord{kKeyBackspace}) {
      GiveOwnKeys(state, command->id, ui.now);
    } else if (pressed == KeyChord{kKeyDelete}) {
      GiveKeys(state, command->id, {}, ui.now);
    } else if (OtherWithKeys(state, *command, pressed) && !(pressed == settings.taken)) {
      settings.taken = pressed;
      return;
    } else {
      GiveKeys(state, command->id, pressed, ui.now);
    }
    state.OpenPopup(Popup::kKeys, command->title);
    return;
  }
}

}  // namespace coppice::editor
