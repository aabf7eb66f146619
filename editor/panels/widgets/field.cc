#include "editor/panels/widgets/field.h"

#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr float kButton = 20;
constexpr char kMinus[] = "\xE2\x80\x93";  // U+2013, as wide as the plus

bool IsWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80U;
}

std::string_view WordAtEnd(std::string_view text) {
  std::size_t start = text.size();
  while (start > 0 && IsWord(text[start - 1])) --start;
  return text.substr(start);
}

bool IsNumber(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

// Empty if these are not three numbers.
std::vector<std::string> SplitPose(const std::string& value) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t end; (end = value.find(';', start)) != std::string::npos; start = end + 1) {
    parts.push_back(value.substr(start, end - start));
  }
  parts.push_back(value.substr(start));
  if (parts.size() != 3 || !std::all_of(parts.begin(), parts.end(), IsNumber)) return {};
  return parts;
}

class FieldDrawer {
 public:
  FieldDrawer(const Ui& ui, EditorState& state, const std::string& path, const std::string& key,
              const Box& box, const std::string& value, const FieldLook& look)
      : ui_(ui), state_(state), path_(path), key_(key), rest_(box), value_(value), look_(look) {}

  FieldResult Draw() {
    ui_.items.Add(path_, rest_);
    if (look_.can_clear && Button("clear", icon::kTimes, "Remove it")) result_.cleared = true;
    switch (look_.kind) {
      case FieldKind::kBool: {
        const bool is_true = value_ == "true";
        const char* glyph = is_true ? icon::kCheck : "";
        if (Button("toggle", glyph, is_true ? "Make it false" : "Make it true")) {
          result_.value = is_true ? "false" : "true";
        }
        break;
      }
      case FieldKind::kNumber:
        Step();
        break;
      case FieldKind::kChoice:
        Choose();
        break;
      case FieldKind::kPose:
        if (Pose()) return std::move(result_);
        break;
      case FieldKind::kText:
        break;
    }
    Text();
    return std::move(result_);
  }

 private:
  // At the right end of what is left.
  bool Button(const char* name, std::string_view text, const char* explanation) {
    const Box box = {{rest_.max.x - kButton * ui_.scale, rest_.min.y}, rest_.max};
    rest_.max.x = box.min.x - 2 * ui_.scale;
    const std::string path = path_ + "/" + name;
    const bool pressed = ui_.Button(path, box, text);
    if (ImGui::IsItemHovered()) Tooltip(ui_, explanation);
    ui_.items.Add(path, box);
    return pressed;
  }

  void Step() {
    if (Button("more", "+", "One step up")) result_.value = Stepped(value_, +1);
    if (Button("less", kMinus, "One step down")) result_.value = Stepped(value_, -1);
  }

  // A list below the field.
  void Choose() {
    ImGui::PushID(key_.c_str());
    if (Button("choices", icon::kCaretDown, "Choose one")) ImGui::OpenPopup("choices");
    const ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({corner.x, corner.y + 2 * ui_.scale}, ImGuiCond_Always, {1, 0});
    const MenuSpacing spacing(ui_);
    if (ImGui::BeginPopup("choices")) {
      for (const std::string& choice : look_.choices) {
        if (ImGui::MenuItem(choice.c_str(), nullptr, choice == value_)) result_.value = choice;
        ui_.items.Add(path_ + "/choice/" + choice,
                      {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
      }
      ImGui::EndPopup();
    }
    ImGui::PopID();
  }

  // A field for each of the three numbers. False if the value is no pose: then it is a text, and a
  // button makes it one.
  bool Pose() {
    static constexpr const char* kParts[] = {"x", "y", "theta"};
    static constexpr const char* kSigns[] = {"x", "y", "\xCE\xB8"};  // a small theta
    std::vector<std::string> parts = SplitPose(value_);
    if (parts.empty()) {
      if (Button("pose", "xy", "A field for each of x, y and theta")) result_.value = "0;0;0";
      return false;
    }
    const float width = rest_.width() / 3;
    const float label = 9 * ui_.scale;
    for (std::size_t i = 0; i < 3; ++i) {
      const float left = rest_.min.x + width * static_cast<float>(i);
      const Box box = {{left + label, rest_.min.y}, {left + width - 3 * ui_.scale, rest_.max.y}};
      ui_.RowText(*ImGui::GetWindowDrawList(), {left, rest_.min.y}, rest_.height(), kSigns[i],
                  {Face::kSans, 10, ui_.palette.text_dim});
      FieldLook look;
      look.hint = kParts[i];
      look.color = look_.color;
      const std::string path = path_ + "/" + kParts[i];
      const std::string key = key_ + "/" + kParts[i];
      const FieldResult part = FieldDrawer(ui_, state_, path, key, box, parts[i], look).Draw();
      if (!part.value) continue;
      parts[i] = *part.value;
      result_.value = parts[0] + ";" + parts[1] + ";" + parts[2];
    }
    return true;
  }

  // While the user types, the text is the state's; before and after it is the document's.
  void Text() {
    const bool is_typing = state_.input.typing.key == key_;
    std::string buffer = is_typing ? state_.input.typing.text : value_;
    ImGui::SetCursorScreenPos(ToIm(rest_.min));
    ImGui::SetNextItemWidth(rest_.width());
    ImGui::PushFont(ui_.fonts.For(buffer, Face::kMono, 11 * ui_.scale));
    ImGui::PushStyleColor(ImGuiCol_Text, look_.color);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, ui_.palette.field);
    ImGui::PushStyleColor(ImGuiCol_Border, ui_.palette.border);
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {5 * ui_.scale, TextTop()});
    ImGui::PushID(key_.c_str());
    if (state_.input.focus_field == path_) {
      ImGui::SetKeyboardFocusHere();
      state_.input.focus_field.clear();
    }
    const std::string hint(look_.hint);
    const ImGuiInputTextFlags flags =
        look_.keys.empty() ? ImGuiInputTextFlags_None : ImGuiInputTextFlags_CallbackCompletion;
    ImGui::InputTextWithHint("##text", hint.c_str(), &buffer, flags, Complete,
                             const_cast<FieldLook*>(&look_));
    if (ImGui::IsItemActive()) ShowCompletions(buffer);
    if (ImGui::IsItemActive()) {
      state_.input.typing = {key_, buffer};
    } else if (is_typing) {
      state_.input.typing = {};
      if (buffer != value_) result_.value = buffer;
    }
    ImGui::PopID();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(3);
    ImGui::PopFont();
  }

  // So that the field is as high as its box.
  float TextTop() const { return std::max((rest_.height() - ImGui::GetFontSize()) / 2, 0.0F); }

  // Tab takes the first.
  static int Complete(ImGuiInputTextCallbackData* data) {
    const auto& look = *static_cast<const FieldLook*>(data->UserData);
    const std::string_view typed(data->Buf, static_cast<std::size_t>(data->CursorPos));
    const std::vector<std::string> found = Completions(typed, look);
    if (found.empty()) return 0;
    std::string rest = found[0].substr(WordAtEnd(typed).size());
    const bool closed = data->CursorPos < data->BufTextLen && data->Buf[data->CursorPos] == '}';
    if (!look.is_script && !closed) rest += '}';
    data->InsertChars(data->CursorPos, rest.c_str());
    return 0;
  }

  void ShowCompletions(const std::string& typed) const {
    constexpr std::size_t kMost = 8;
    std::vector<std::string> found = Completions(typed, look_);
    if (found.empty()) return;
    if (found.size() > kMost) found.resize(kMost);
    std::string text = "Tab: " + found[0];
    for (std::size_t i = 1; i < found.size(); ++i) text += "\n     " + found[i];
    ImGui::SetNextWindowPos({rest_.min.x, rest_.max.y + 2});
    const float pad = 6 * ui_.scale;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    ImGui::PushStyleColor(ImGuiCol_PopupBg, ui_.palette.panel);
    ImGui::PushStyleColor(ImGuiCol_Text, ui_.palette.text);
    ImGui::SetTooltip("%s", text.c_str());
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar();
    ui_.items.Add(path_ + "/completions", rest_);
  }

  const Ui& ui_;
  EditorState& state_;
  const std::string& path_;
  const std::string& key_;
  Box rest_;
  const std::string& value_;
  const FieldLook& look_;
  FieldResult result_;
};

}  // namespace

FieldResult DrawField(const Ui& ui, EditorState& state, const std::string& path,
                      const std::string& key, const Box& box, const std::string& value,
                      const FieldLook& look) {
  return FieldDrawer(ui, state, path, key, box, value, look).Draw();
}

std::vector<std::string> Completions(std::string_view text, const FieldLook& look) {
  std::vector<std::string> found;
  const std::string_view word = WordAtEnd(text);
  const std::string_view before = text.substr(0, text.size() - word.size());
  const bool fits = look.is_script ? !word.empty() : before == "{" || before == "{@";
  if (!fits) return found;
  for (const std::string& key : look.keys) {
    if (key.size() > word.size() && key.compare(0, word.size(), word) == 0) found.push_back(key);
  }
  return found;
}

FieldKind KindOf(std::string_view type) {
  if (type == "Pose2D") return FieldKind::kPose;
  if (type == "bool") return FieldKind::kBool;
  for (const std::string_view name :
       {"int", "unsigned", "unsigned int", "int64_t", "uint64_t", "long", "float", "double",
        "int64", "uint64", "int32_t", "uint32_t", "uint8_t", "size_t"}) {
    if (type == name) return FieldKind::kNumber;
  }
  return FieldKind::kText;
}

std::vector<std::string> ChoicesIn(std::string_view description) {
  std::vector<std::string> choices;
  const std::size_t colon = description.rfind(": ");
  if (colon == std::string_view::npos) return choices;
  std::string_view rest = description.substr(colon + 2);
  for (bool more = true; more;) {
    const auto end =
        static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), IsWord) - rest.begin());
    if (end == 0) return {};
    choices.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end);
    more = false;
    for (const std::string_view between : {", ", " or "}) {
      if (rest.substr(0, between.size()) != between) continue;
      rest.remove_prefix(between.size());
      more = true;
    }
  }
  return rest.empty() && choices.size() > 1 ? choices : std::vector<std::string>();
}

std::optional<std::string> Stepped(const std::string& number, int by) {
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  if (number.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  const std::size_t point = number.find('.');
  const int decimals = point == std::string::npos ? 0 : static_cast<int>(number.size() - point - 1);
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", std::min(decimals, 9),
                value + by * std::pow(10.0, -std::min(decimals, 9)));
  return std::string(text);
}

}  // namespace coppice::editor
