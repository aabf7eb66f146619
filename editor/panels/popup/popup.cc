// One window for all questions: it is as high as its content, the field has the keys at once, the
// arrow keys walk in the rows below it. So a new question is a `Prompt` or a `List`, and needs no
// window of its own.
#include "editor/panels/popup/popup.h"

#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "editor/keys/recent.h"
#include "editor/panels/popup/choices.h"
#include "editor/panels/popup/file_rows.h"
#include "editor/panels/popup/key_list.h"
#include "editor/panels/popup/popup_rows.h"
#include "editor/panels/popup/type_choices.h"
#include "editor/panels/widgets/panel.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

constexpr float kWidth = 560;
constexpr float kKeysWidth = 760;
constexpr float kField = 24;
constexpr float kBelowAsked = 9;
constexpr std::size_t kMostChoices = 200;  // that a list offers

bool Pressed(const EditorState& state, Key key) {
  return std::any_of(state.input.keys.begin(), state.input.keys.end(),
                     [&](const KeyEvent& event) { return event.key == key; });
}

bool Confirmed(const EditorState& state) {
  return Pressed(state, kKeyEnter) || Pressed(state, kKeyKeypadEnter);
}

int TakeNewText(ImGuiInputTextCallbackData* data) {
  PopupState& popup = *static_cast<PopupState*>(data->UserData);
  if (!popup.new_text || data->EventFlag != ImGuiInputTextFlags_CallbackAlways) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, popup.new_text->c_str());
  popup.new_text.reset();
  return 0;
}

class PopupWindow {
 public:
  PopupWindow(const Ui& ui, EditorState& state) : ui_(ui), state_(state) {}

  void Draw() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float wished = state_.popup.kind == Popup::kKeys ? kKeysWidth : kWidth;
    const float width = std::min(wished * ui_.scale, display.x - 20);
    const Point size = {width, std::min(Height(width), display.y - 80 * ui_.scale)};
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
    const bool outside = ImGui::IsMouseClicked(0) && !state_.popup.is_new &&
                         !Box{at, at + size}.Contains(FromIm(ImGui::GetIO().MousePos));
    Content();
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(2);
    if (Pressed(state_, kKeyEscape) || outside) state_.popup.kind = Popup::kNone;
  }

 private:
  // For what it holds at that width.
  float Height(float width) const {
    const std::string asked = Asked();
    const std::size_t rows = Rows();
    float height = 20 + static_cast<float>(rows) * kRowHeight;
    if (!asked.empty()) {
      const float room = width - 20 * ui_.scale;
      height += kBelowAsked + ui_.ParagraphHeight(asked, {Face::kSans, 12, 0}, room) / ui_.scale;
      if (HasField()) height += kField;
      if (rows > 0) height += 6;
    }
    if (!state_.popup.error.empty()) height += 24;
    return height * ui_.scale;
  }

  // Stands above the field, for what is in the field would hide it.
  std::string Asked() const {
    switch (state_.popup.kind) {
      case Popup::kOpen:
        return FileHint(state_);
      case Popup::kConnect:
        return "Connect to a robot: HOST:PORT, or HOST:PORT/TREE for one of its trees";
      case Popup::kPalette:
        return "Search commands, nodes, trees and robots";
      case Popup::kList:
        return state_.popup.list.hint;
      case Popup::kPrompt:
        return state_.popup.prompt.hint;
      case Popup::kKeys:
        return "Search commands by title, ID or keys; Enter gives the chosen one other keys";
      case Popup::kAdd:
        return "Add a node: its type";
      case Popup::kChangeType:
        return "Change the type to";
      case Popup::kRename:
        return "Rename the node; without a name it is called by its type";
      default:
        return {};
    }
  }

  bool HasField() const {
    if (state_.popup.kind == Popup::kList) return state_.popup.list.is_searched;
    return state_.popup.kind != Popup::kPrompt || state_.popup.prompt.asks_for_text;
  }

  std::size_t Rows() const {
    switch (state_.popup.kind) {
      case Popup::kKeys:
        return state_.popup.rows;
      case Popup::kOpen:
      case Popup::kConnect:
      case Popup::kPalette:
      case Popup::kList:
        return std::min(state_.popup.rows, kPopupRows);
      case Popup::kPrompt:
        return state_.popup.prompt.preview ? std::min(state_.popup.rows, kPopupRows) : 0;
      case Popup::kAdd:
      case Popup::kChangeType:
        return std::min(state_.popup.rows, kPopupRows) + 1;
      case Popup::kNewKeys:
        return 3;
      case Popup::kPasteErrors:
        return state_.popup.problems.size() + 1;
      default:
        return 0;
    }
  }

  void Content() {
    switch (state_.popup.kind) {
      case Popup::kOpen:
        state_.popup.files.was_empty = state_.popup.text.empty();
        Input();
        DrawFileRows(ui_, state_);
        break;
      case Popup::kConnect:
        Input();
        Robots();
        break;
      case Popup::kPalette:
        Input();
        Choices(FindChoices(state_, state_.popup.text, ui_.now, kMostChoices));
        break;
      case Popup::kList:
        Input();
        Choices(state_.popup.list.rows(state_.popup.text));
        break;
      case Popup::kPrompt:
        Ask();
        break;
      case Popup::kKeys:
        Input();
        DrawKeyList(ui_, state_);
        break;
      case Popup::kNewKeys:
        DrawNewKeys(ui_, state_);
        break;
      case Popup::kAdd:
        Input();
        Types(true);
        break;
      case Popup::kChangeType:
        Input();
        Types(false);
        break;
      case Popup::kRename:
        Input();
        if (Confirmed(state_) && TreeEditor(state_, ui_.now).Rename(state_.popup.text)) Close();
        break;
      case Popup::kPasteErrors:
        PasteErrors();
        break;
      case Popup::kNone:
        break;
    }
    const std::string& error = state_.popup.error;
    if (error.empty()) return;
    ImGui::PushFont(ui_.fonts.For(error, Face::kSans, 13 * ui_.scale));
    ImGui::PushStyleColor(ImGuiCol_Text, ui_.palette.error);
    ImGui::TextUnformatted(error.c_str());
    ui_.items.Add("popup/error",
                  {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
    ImGui::PopStyleColor();
    ImGui::PopFont();
  }

  void Input() {
    const std::string asked = Asked();
    ImGui::PushFont(ui_.fonts.For(asked, Face::kSans, 12 * ui_.scale));
    ImGui::PushStyleColor(ImGuiCol_Text, ui_.palette.text_dim);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(asked.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    const bool is_new = std::exchange(state_.popup.is_new, false);
    if (!HasField()) return;
    if (is_new) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    ImGui::PushFont(ui_.fonts.For(state_.popup.text, Face::kSans, 14 * ui_.scale));
    ImGuiInputTextFlags flags =
        state_.popup.selects_text ? ImGuiInputTextFlags_AutoSelectAll : ImGuiInputTextFlags_None;
    if (state_.popup.kind == Popup::kOpen) {  // whose Tab completes
      flags |= ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackAlways;
    }
    ImGui::PushID(state_.popup.number);
    const bool is_changed =
        ImGui::InputText("##input", &state_.popup.text, flags, TakeNewText, &state_.popup);
    ImGui::PopID();
    if (ImGui::IsItemDeactivated() && Confirmed(state_)) {  // if it stays, one goes on typing
      state_.popup.is_new = true;
      state_.popup.selects_text = false;
    }
    if (is_changed) {
      state_.popup.choice = 0;
      state_.popup.files.walked = false;
      state_.popup.error.clear();
    }
    ImGui::PopFont();
    ui_.items.Add("popup/input",
                  {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
  }

  // Those that were met before and those of the network; the arrows choose one of them.
  void Robots() {
    const std::vector<OfferedRobot> robots = state_.OfferedRobots();
    state_.popup.rows = robots.size();
    PopupState& popup = state_.popup;
    const bool has_walked = popup.files.walked;
    const bool walks = Pressed(state_, kKeyDown) || Pressed(state_, kKeyUp);
    if (walks && !has_walked) popup.choice = Pressed(state_, kKeyDown) ? -1 : 0;
    popup.files.walked = (has_walked || walks) && !robots.empty();
    std::optional<std::string> chosen;
    if (!robots.empty()) {
      PopupRows rows(ui_, state_, robots.size(), popup.files.walked);
      for (const OfferedRobot& robot : robots) {
        if (rows.Next(robot.endpoint, robot.note, robot.word())) chosen = robot.endpoint;
      }
    }
    if (Confirmed(state_)) {
      const auto row = static_cast<std::size_t>(popup.choice);
      chosen = popup.files.walked ? robots[row].endpoint : popup.text;
    }
    if (chosen) Connect(*chosen);
  }

  void Connect(const std::string& endpoint) {
    const Outcome connected = state_.services.connect(endpoint);
    state_.popup.error = connected.problem();
    if (connected) state_.popup.kind = Popup::kNone;
  }

  // What is asked may ask further.
  void Ask() {
    const Prompt prompt = state_.popup.prompt;
    Input();
    const bool confirmed = Confirmed(state_);
    if (prompt.preview && !confirmed) Preview(prompt.preview(state_.popup.text));
    if (!confirmed) return;
    Close();
    const Outcome answered = prompt.run(state_.popup.text);
    if (answered) return;
    state_.popup.kind = Popup::kPrompt;
    state_.popup.is_new = true;  // the user goes on typing
    state_.popup.selects_text = false;
    state_.popup.error = answered.problem();
  }

  void Preview(const std::vector<Choice>& rows) {
    state_.popup.rows = rows.size();
    const bool has_choice = !HasField();
    if (rows.empty() && !has_choice) return;
    int chosen = Chosen(rows, has_choice);
    if (has_choice && Pressed(state_, kKeySpace) && !rows.empty()) chosen = state_.popup.choice;
    if (chosen < 0) return;
    const auto& run = rows[static_cast<std::size_t>(chosen)].run;
    if (run) run();
  }

  void Choices(const std::vector<Choice>& choices) {
    state_.popup.rows = std::max<std::size_t>(choices.size(), 1);
    int chosen = Chosen(choices, true);
    if (Confirmed(state_) && !choices.empty()) chosen = state_.popup.choice;
    if (chosen < 0) return;
    state_.popup.kind = Popup::kNone;  // before running: the command may open another
    choices[static_cast<std::size_t>(chosen)].run();
  }

  // Draws the rows; the one that was clicked, or -1.
  int Chosen(const std::vector<Choice>& choices, bool has_choice) {
    PopupRows rows(ui_, state_, choices.size(), has_choice);
    if (choices.empty() && has_choice) PaintHelp("popup/nothing", "nothing matches what was typed");
    int chosen = -1;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      const Choice& choice = choices[i];
      if (rows.Next(choice.title, choice.note, choice.kind)) chosen = static_cast<int>(i);
    }
    return chosen;
  }

  void Types(bool add) {
    const std::vector<TypeChoice> types = FindTypes(state_, state_.popup.text, add, kMostChoices);
    state_.popup.rows = types.size();
    int chosen = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    {
      PopupRows rows(ui_, state_, types.size());
      for (std::size_t i = 0; i < types.size(); ++i) {
        if (rows.Next(types[i].type, types[i].note, types[i].kind)) chosen = static_cast<int>(i);
      }
    }
    PaintHelp("popup/help", add ? AddHelp() : ChangeHelp(types));
    ImGui::PopStyleVar();
    if (Confirmed(state_) && !types.empty()) chosen = state_.popup.choice;
    if (chosen < 0) return;
    Take(types[static_cast<std::size_t>(chosen)], add);
  }

  std::string AddHelp() const {
    const std::string place = TreeEditor(state_, ui_.now).PlaceOfNew();
    const bool is_after = place.rfind("after ", 0) == 0;  // so it is with Shift
    return "Enter: " + place + (is_after ? "" : "     Shift+Enter: after it") +
           "     Ctrl+Enter: around it";
  }

  std::string ChangeHelp(const std::vector<TypeChoice>& types) const {
    if (types.empty()) return {};
    const std::string lost =
        TreeEditor(state_, ui_.now)
            .LostByChange(types[static_cast<std::size_t>(state_.popup.choice)].type);
    return lost.empty() ? "all ports stay" : "this loses " + lost;
  }

  void Take(const TypeChoice& choice, bool add) {
    TreeEditor edit(state_, ui_.now);
    const bool done =
        add ? edit.Add(choice.xml, choice.type, ChosenPlace()) : edit.ChangeType(choice.type);
    if (done) {
      UseAgain(state_.recent.types, choice.type);
      Close();
    } else {
      state_.popup.error = state_.notice.text;
    }
  }

  AddWhere ChosenPlace() const {
    for (const KeyEvent& event : state_.input.keys) {
      if (event.key != kKeyEnter && event.key != kKeyKeypadEnter) continue;
      const int held = event.modifiers | state_.popup.held;
      if (held & kCtrl) return AddWhere::kAround;
      if (held & kShift) return AddWhere::kAfter;
    }
    return AddWhere::kChild;
  }

  void Close() { state_.popup.kind = Popup::kNone; }

  void PasteErrors() {
    state_.popup.is_new = false;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const Row head = NextRow(ui_, "popup/head", false);
    PaintPopupRow(ui_, head.box, "Nothing was pasted: the text has errors", "Esc", "");
    for (std::size_t i = 0; i < state_.popup.problems.size(); ++i) {
      const Row row = NextRow(ui_, "popup/error/" + std::to_string(i), false);
      PaintPopupRow(ui_, row.box, ToString(state_.popup.problems[i]), "", "");
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

  const Ui& ui_;
  EditorState& state_;
};

}  // namespace

void DrawPopup(const Ui& ui, EditorState& state) {
  if (state.popup.kind != Popup::kNone) PopupWindow(ui, state).Draw();
}

}  // namespace coppice::editor
