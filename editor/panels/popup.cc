#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "editor/core/tree_editor.h"
#include "editor/panels/choices.h"
#include "editor/panels/key_list.h"
#include "editor/panels/panel.h"
#include "editor/panels/panels.h"
#include "editor/panels/type_choices.h"

namespace coppice::editor {
namespace {

constexpr float kWidth = 560;
constexpr float kKeysWidth = 760;
constexpr float kField = 24;
constexpr float kAsked = 20;  // the line above the field
constexpr std::size_t kRows = 12;

bool Pressed(const EditorState& state, Key key) {
  return std::any_of(state.keys.begin(), state.keys.end(),
                     [&](const KeyEvent& event) { return event.key == key; });
}

bool Confirmed(const EditorState& state) {
  return Pressed(state, kKeyEnter) || Pressed(state, kKeyKeypadEnter);
}

class PopupWindow {
 public:
  PopupWindow(const Ui& ui, EditorState& state) : ui_(ui), state_(state) {}

  void Draw() {
    const std::size_t rows = Rows();
    const bool asks = state_.popup != Popup::kPasteErrors && state_.popup != Popup::kNewKeys;
    float height = (asks ? kAsked + kField : 0) + 20 + static_cast<float>(rows) * kRowHeight;
    if (rows > 0 && asks) height += 6;
    if (!state_.popup_error.empty()) height += 24;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = state_.popup == Popup::kKeys ? kKeysWidth : kWidth;
    const Point size = {std::min(width * ui_.scale, display.x - 20),
                        std::min(height * ui_.scale, display.y - 80 * ui_.scale)};
    const Point at = {(display.x - size.x) / 2, 56 * ui_.scale};
    ImGui::SetNextWindowPos(ToIm(at));
    ImGui::SetNextWindowSize(ToIm(size));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ui_.palette.panel);
    ImGui::PushStyleColor(ImGuiCol_Border, ui_.palette.accent);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * ui_.scale, 10 * ui_.scale});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::SetNextWindowFocus();
    ImGui::Begin(
        "popup", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ui_.items.Add("popup", {at, at + size});
    const bool outside = ImGui::IsMouseClicked(0) && !state_.popup_is_new &&
                         !Box{at, at + size}.Contains(FromIm(ImGui::GetIO().MousePos));
    Content();
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(2);
    if (Pressed(state_, kKeyEscape) || outside) state_.popup = Popup::kNone;
  }

 private:
  std::size_t Rows() const {
    switch (state_.popup) {
      case Popup::kPalette:
      case Popup::kList:
      case Popup::kKeys:
        return state_.popup_rows;
      case Popup::kPrompt:
        return state_.prompt.preview ? state_.popup_rows : 0;
      case Popup::kAdd:
      case Popup::kChangeType:
        return state_.popup_rows + 1;
      case Popup::kNewKeys:
        return 3;
      case Popup::kPasteErrors:
        return state_.popup_problems.size() + 1;
      default:
        return 0;
    }
  }

  void Content() {
    switch (state_.popup) {
      case Popup::kOpen:
        Input("Open a file: its path (trees as XML, or a record of a run)");
        if (Confirmed(state_)) Open();
        break;
      case Popup::kConnect:
        Input("Connect to a robot: HOST:PORT, or HOST:PORT/TREE for one of its trees");
        if (Confirmed(state_)) Connect();
        break;
      case Popup::kPalette:
        Input("Search commands, nodes, trees and robots");
        Choices(FindChoices(state_, state_.popup_text, ui_.now, kRows));
        break;
      case Popup::kList:
        Input(state_.list.hint);
        Choices(state_.list.rows(state_.popup_text));
        break;
      case Popup::kPrompt:
        Ask();
        break;
      case Popup::kKeys:
        Input("Search commands by title, ID or keys; Enter gives the chosen one other keys");
        DrawKeyList(ui_, state_);
        break;
      case Popup::kNewKeys:
        DrawNewKeys(ui_, state_);
        break;
      case Popup::kAdd:
        Input("Add a node: its type");
        Types(true);
        break;
      case Popup::kChangeType:
        Input("Change the type to");
        Types(false);
        break;
      case Popup::kRename:
        Input("Rename the node; without a name it is called as its type");
        if (Confirmed(state_) && TreeEditor(state_, ui_.now).Rename(state_.popup_text)) Close();
        break;
      case Popup::kSaveAs:
        Input("Save the file under another name: its path");
        if (Confirmed(state_)) TreeEditor(state_, ui_.now).SaveAs(state_.popup_text);
        break;
      case Popup::kPasteErrors:
        PasteErrors();
        break;
      case Popup::kNone:
        break;
    }
    if (state_.popup_error.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui_.palette.error);
    ImGui::TextUnformatted(state_.popup_error.c_str());
    ImGui::PopStyleColor();
  }

  // What is asked stands above the field, for what is in the field would hide it.
  void Input(const std::string& asked) {
    ImGui::PushFont(ui_.fonts.Pick(Face::kSans, 12 * ui_.scale));
    ImGui::PushStyleColor(ImGuiCol_Text, ui_.palette.text_dim);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(asked.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (state_.popup_is_new) ImGui::SetKeyboardFocusHere();
    state_.popup_is_new = false;
    ImGui::SetNextItemWidth(-1);
    ImGui::PushFont(ui_.fonts.Pick(Face::kSans, 14 * ui_.scale));
    if (ImGui::InputText("##input", &state_.popup_text)) {
      state_.popup_choice = 0;
      state_.popup_error.clear();
    }
    ImGui::PopFont();
    ui_.items.Add("popup/input",
                  {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
  }

  void Open() {
    if (state_.open_file(state_.popup_text)) {
      state_.popup = Popup::kNone;
    } else {
      std::error_code error;
      state_.popup_error = std::filesystem::exists(state_.popup_text, error)
                               ? "nothing to show in this file; see Problems"
                               : "there is no such file";
    }
  }

  void Connect() {
    state_.popup_error = state_.connect(state_.popup_text);
    if (state_.popup_error.empty()) state_.popup = Popup::kNone;
  }

  // What is asked may ask further.
  void Ask() {
    const Prompt prompt = state_.prompt;
    Input(prompt.hint);
    const bool confirmed = Confirmed(state_);
    if (prompt.preview && !confirmed) Preview(prompt.preview(state_.popup_text));
    if (!confirmed) return;
    Close();
    const std::string refusal = prompt.run(state_.popup_text);
    if (refusal.empty()) return;
    state_.popup = Popup::kPrompt;
    state_.popup_is_new = true;  // the user goes on typing
    state_.popup_error = refusal;
  }

  void Preview(const std::vector<Choice>& rows) {
    state_.popup_rows = rows.size();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::Dummy({1, 6 * ui_.scale});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row row = NextRow(ui_, "popup/" + std::to_string(i), false);
      Paint(row.box, rows[i].title, rows[i].note, rows[i].kind);
      if (row.clicked && rows[i].run) rows[i].run();
    }
    ImGui::PopStyleVar();
  }

  void Choices(const std::vector<Choice>& choices) {
    const int count = static_cast<int>(choices.size());
    state_.popup_rows = std::max<std::size_t>(choices.size(), 1);
    Choose(count);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::Dummy({1, 6 * ui_.scale});
    if (choices.empty()) PaintHelp("popup/nothing", "nothing fits what was typed");
    int chosen = -1;
    for (int i = 0; i < count; ++i) {
      const Choice& choice = choices[static_cast<std::size_t>(i)];
      const Row row = NextRow(ui_, "popup/" + std::to_string(i), i == state_.popup_choice);
      Paint(row.box, choice.title, choice.note, choice.kind);
      if (row.clicked) chosen = i;
    }
    ImGui::PopStyleVar();
    if (Confirmed(state_) && count > 0) chosen = state_.popup_choice;
    if (chosen < 0) return;
    state_.popup = Popup::kNone;  // before running: the command may open another
    choices[static_cast<std::size_t>(chosen)].run();
  }

  // Moves the highlighted row with the arrow keys.
  void Choose(int count) {
    if (Pressed(state_, kKeyDown)) ++state_.popup_choice;
    if (Pressed(state_, kKeyUp)) --state_.popup_choice;
    state_.popup_choice = std::clamp(state_.popup_choice, 0, std::max(count - 1, 0));
  }

  void Types(bool add) {
    const std::vector<TypeChoice> types = FindTypes(state_, state_.popup_text, add, kRows);
    state_.popup_rows = types.size();
    Choose(static_cast<int>(types.size()));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::Dummy({1, 6 * ui_.scale});
    int chosen = -1;
    for (std::size_t i = 0; i < types.size(); ++i) {
      const Row row =
          NextRow(ui_, "popup/" + std::to_string(i), static_cast<int>(i) == state_.popup_choice);
      Paint(row.box, types[i].type, types[i].note, types[i].kind);
      if (row.clicked) chosen = static_cast<int>(i);
    }
    PaintHelp("popup/help", add ? AddHelp() : ChangeHelp(types));
    ImGui::PopStyleVar();
    if (Confirmed(state_) && !types.empty()) chosen = state_.popup_choice;
    if (chosen < 0) return;
    Take(types[static_cast<std::size_t>(chosen)], add);
  }

  std::string AddHelp() const {
    return "Enter " + TreeEditor(state_, ui_.now).PlaceOfNew() +
           "     Shift+Enter behind     Ctrl+Enter around";
  }

  std::string ChangeHelp(const std::vector<TypeChoice>& types) const {
    if (types.empty()) return {};
    const std::string lost =
        TreeEditor(state_, ui_.now)
            .LostByChange(types[static_cast<std::size_t>(state_.popup_choice)].type);
    return lost.empty() ? "all ports stay" : "this loses " + lost;
  }

  void Take(const TypeChoice& choice, bool add) {
    TreeEditor edit(state_, ui_.now);
    const bool done =
        add ? edit.Add(choice.xml, choice.type, ChosenPlace()) : edit.ChangeType(choice.type);
    if (done) {
      RememberType(state_, choice.type);
      Close();
    } else {
      state_.popup_error = state_.notice.text;
    }
  }

  AddWhere ChosenPlace() const {
    for (const KeyEvent& event : state_.keys) {
      if (event.key != kKeyEnter && event.key != kKeyKeypadEnter) continue;
      if (event.modifiers & kCtrl) return AddWhere::kAround;
      if (event.modifiers & kShift) return AddWhere::kAfter;
    }
    return AddWhere::kChild;
  }

  void Close() { state_.popup = Popup::kNone; }

  void PasteErrors() {
    state_.popup_is_new = false;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const Row head = NextRow(ui_, "popup/head", false);
    Paint(head.box, "Nothing was pasted: the text has errors", "Esc", "");
    for (std::size_t i = 0; i < state_.popup_problems.size(); ++i) {
      const Row row = NextRow(ui_, "popup/error/" + std::to_string(i), false);
      Paint(row.box, ToString(state_.popup_problems[i]), "", "");
    }
    ImGui::PopStyleVar();
    if (Confirmed(state_)) Close();
  }

  void PaintHelp(const std::string& path, const std::string& text) {
    const Row row = NextRow(ui_, path, false);
    ui_.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{6 * ui_.scale, 0},
                row.box.height(), text, {Face::kSans, 11, ui_.palette.text_dim},
                row.box.width() - 12 * ui_.scale);
  }

  void Paint(const Box& box, const std::string& title, const std::string& note,
             const std::string& kind) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const TextStyle dim{Face::kSans, 11, ui_.palette.text_dim};
    const float kind_width = 64 * ui_.scale;
    const float pad = 6 * ui_.scale;
    if (!kind.empty()) ui_.RowText(list, box.min + Point{pad, 0}, box.height(), kind, dim);
    const float left = box.min.x + (kind.empty() ? pad : kind_width);
    const float note_width = std::min(ui_.Width(note, dim), box.width() * 0.4F);
    ui_.RowText(list, {left, box.min.y}, box.height(), title, {Face::kSans, 12, ui_.palette.text},
                box.max.x - left - note_width - 3 * pad);
    ui_.RowText(list, {box.max.x - note_width - pad, box.min.y}, box.height(), note, dim,
                note_width + 1);
  }

  const Ui& ui_;
  EditorState& state_;
};

}  // namespace

void DrawPopup(const Ui& ui, EditorState& state) {
  if (state.popup != Popup::kNone) PopupWindow(ui, state).Draw();
}

}  // namespace coppice::editor
