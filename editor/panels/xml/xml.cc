// The field is our own, not Dear ImGui's for text of many lines: what is typed must be a step of
// the project's one history, so that it is undone in one order with what is done on the canvas; the
// caret selects the node that it stands in; and of a file with many thousand lines only those in
// sight may cost anything.
#include "editor/panels/xml/xml.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "editor/panels/widgets/panel.h"
#include "editor/panels/xml/xml_gutter.h"
#include "editor/panels/xml/xml_keys.h"
#include "editor/panels/xml/xml_line.h"
#include "editor/panels/xml/xml_shown.h"
#include "editor/theme/icons.h"
#include "editor/workspace/project_editor.h"

namespace coppice::editor {
namespace {

constexpr float kLineHeight = 18;
constexpr float kNumberWidth = kXmlNumberWidth;

constexpr std::size_t kMostLines = 1'000'000;  // the last one holds the rest

using Line = XmlLines::Line;

std::vector<Line> SplitLines(const std::string& text) {
  std::vector<Line> lines;
  std::size_t start = 0;
  while (start <= text.size()) {
    const bool is_rest = lines.size() + 1 == kMostLines;
    const std::size_t end = is_rest ? text.size() : std::min(text.find('\n', start), text.size());
    const bool cr = end > start && end < text.size() && text[end - 1] == '\r';
    lines.push_back(
        {static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(cr ? end - 1 : end)});
    start = end + 1;
  }
  return lines;
}

// Documents never change, so their lines are looked for once.
const std::vector<Line>& LinesOf(const ShownXml& shown, XmlLines& known) {
  const bool is_known = known.of && shown.document && &known.of->text() == &shown.document->text();
  if (is_known) return known.lines;
  known.of.reset();
  if (shown.document) known.of = *shown.document;
  known.lines = SplitLines(*shown.text);
  return known.lines;
}

// What the keys of this frame make of the text.
class XmlTyping {
 public:
  XmlTyping(const Ui& ui, EditorState& state, const ShownXml& shown)
      : ui_(ui), state_(state), pane_(state.xml.pane), shown_(shown) {}

  void Run() {
    TextEdit edit{*shown_.text, pane_.at, pane_.anchor};
    const TextClipboard clipboard = {state_.services.get_clipboard, state_.services.set_clipboard};
    for (const KeyEvent& event : state_.input.keys) {
      const KeyChord chord = {event.key, event.modifiers};
      if (event.key == kKeyEscape) pane_.focused = false;
      if (IsTextKey(chord)) PressTextKey(chord, clipboard, edit);
    }
    const std::string typed = Typed();
    if (!typed.empty()) edit.Put(typed);
    const bool moved = edit.at != pane_.at || edit.anchor != pane_.anchor;
    pane_.at = edit.at;
    pane_.anchor = edit.anchor;
    pane_.follow = pane_.follow || moved;
    if (edit.text != *shown_.text) Become(std::move(edit));
    if (moved) SelectNode();
  }

 private:
  static std::string Typed() {
    std::string typed;
    for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
      if (c < 0x20) continue;
      if (c < 0x80) {
        typed += static_cast<char>(c);
      } else if (c < 0x800) {
        typed += static_cast<char>(0xC0 | (c >> 6));
        typed += static_cast<char>(0x80 | (c & 0x3F));
      } else {
        typed += static_cast<char>(0xE0 | (c >> 12));
        typed += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        typed += static_cast<char>(0x80 | (c & 0x3F));
      }
    }
    return typed;
  }

  // What is typed in one go, within a line, is one step of the history.
  void Become(TextEdit edit) {
    const Edit change = Difference(*shown_.text, edit.text);
    const std::size_t start = change[0].offset;
    const std::size_t stop = start + change[0].removed;
    const bool goes_on = start == pane_.typed_to || stop == pane_.typed_to;
    const bool line_end = change[0].inserted.find('\n') != std::string::npos;
    const std::string name = "Type in " + shown_.path.substr(shown_.path.rfind('/') + 1);
    state_.workspace.project().SetText(shown_.path, name, std::move(edit.text),
                                       goes_on && !line_end);
    pane_.typed_to = pane_.at;
    state_.workspace.Refresh(ui_.now);
  }

  // The canvas follows the caret.
  void SelectNode() {
    const EditedFile* file = state_.workspace.project().Find(shown_.path);
    if (!file || !file->document) return;
    const ElementIndex element = file->document->ElementAt(static_cast<std::uint32_t>(pane_.at));
    if (element == kNoElement || !IsNode(*file->document, element)) return;
    ProjectEditor(state_, ui_.now).GoTo(shown_.path, file->document->element(element).offset);
  }

  const Ui& ui_;
  EditorState& state_;
  XmlPane& pane_;
  const ShownXml& shown_;
};

class XmlPanel {
 public:
  XmlPanel(const Ui& ui, EditorState& state, const ShownXml& shown)
      : ui_(ui),
        pane_(state.xml.pane),
        gutter_(state.xml.gutter),
        shown_(shown),
        lines_(LinesOf(shown, state.xml.lines)),
        list_(*ImGui::GetWindowDrawList()) {
    for (const OpenFile& file : state.workspace.files()) {
      for (const Diagnostic& problem : file.problems) {
        if (problem.where.file == shown.path) problems_.push_back(&problem);
      }
    }
  }

  void Draw() {
    Follow();
    ScrollAcross();
    first_y_ = ImGui::GetCursorScreenPos().y;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines_.size()), kLineHeight * ui_.scale);
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        DrawLine(static_cast<std::size_t>(i));
      }
    }
    pane_.widest = widest_;
    if (shown_.can_edit) Mouse();
  }

 private:
  std::size_t LineOf(std::size_t offset) const {
    const auto behind =
        std::upper_bound(lines_.begin(), lines_.end(), offset,
                         [](std::size_t at, const Line& line) { return at < line.begin; });
    return static_cast<std::size_t>(behind - lines_.begin()) - 1;
  }

  std::string_view TextOf(std::size_t line) const {
    return std::string_view(*shown_.text)
        .substr(lines_[line].begin, lines_[line].end - lines_[line].begin);
  }

  // To the caret while the user types, else to the node that was selected last.
  void Follow() {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("followed");
    const int line = static_cast<int>(LineOf(pane_.focused ? pane_.at : shown_.begin));
    const bool moved = storage.GetInt(id, -1) != line;
    storage.SetInt(id, line);
    const bool wanted = pane_.focused ? std::exchange(pane_.follow, false) : shown_.end > 0;
    if (pane_.focused && wanted) ShowColumn(line);
    if (!pane_.focused && moved) pane_.left = LeftForNode(line);
    if (IsOtherFile() && !wanted) ImGui::SetScrollY(0);
    if (!moved || !wanted) return;
    const float height = kLineHeight * ui_.scale;
    const float at = static_cast<float>(line) * height;
    const float room = ImGui::GetWindowHeight();
    const float top = ImGui::GetScrollY();
    if (pane_.focused && at > top && at + 2 * height < top + room) return;
    ImGui::SetScrollY(std::max(0.0F, at - room / 2));
  }

  // Since the frame before.
  bool IsOtherFile() const {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("file");
    const int file = static_cast<int>(ImGui::GetID(shown_.path.c_str()));
    const bool is_other = storage.GetInt(id, file) != file;
    storage.SetInt(id, file);
    return is_other;
  }

  // A tag that is indented beyond the middle of the tile is brought to its left side.
  float LeftForNode(int line) const {
    if (shown_.end == 0) return 0;
    const auto number = static_cast<std::size_t>(line);
    const float column = XmlColumn(ui_, TextOf(number), shown_.begin - lines_[number].begin);
    return column > Room() / 2 ? column - 24 * ui_.scale : 0;
  }

  // Long lines go to the left, so that the caret is seen.
  void ShowColumn(int line) {
    const auto number = static_cast<std::size_t>(line);
    const float column = XmlColumn(ui_, TextOf(number), pane_.at - lines_[number].begin);
    const float margin = 24 * ui_.scale;
    pane_.left = std::min(pane_.left, column - margin);
    pane_.left = std::max({pane_.left, column + margin - Room(), 0.0F});
  }

  void ScrollAcross() {
    const ImGuiIO& io = ImGui::GetIO();
    const float wheel = io.MouseWheelH + (io.KeyShift ? io.MouseWheel : 0);
    if (wheel == 0 || !ImGui::IsWindowHovered()) return;
    const float most = std::max(pane_.widest + 24 * ui_.scale - Room(), 0.0F);
    pane_.left = std::clamp(pane_.left - wheel * 40 * ui_.scale, 0.0F, most);
  }

  // For the text, right of the numbers.
  float Room() const { return ImGui::GetContentRegionAvail().x - (kNumberWidth + 4) * ui_.scale; }
  float TextLeft(const Box& row) const { return row.min.x + kNumberWidth * ui_.scale - pane_.left; }

  void DrawLine(std::size_t number) {
    const std::string label = std::to_string(number + 1);
    const Row row = NextRow(ui_, "xml/" + label, false, kLineHeight);
    if (!row.visible) return;
    if (pane_.focused && number == LineOf(pane_.at)) {
      ui_.Fill(list_, row.box, Fade(ui_.palette.text_dim, 0.06F));
    }
    MarkNode(number, row.box);
    const Diagnostic* problem = ProblemOf(number);
    if (problem) MarkProblem(*problem, row);
    const TextStyle style{Face::kMono, 11, ui_.palette.text_dim};
    const float right = row.box.min.x + (kNumberWidth - 14) * ui_.scale;
    ui_.RowText(list_, {right - ui_.Width(label, style), row.box.min.y}, row.box.height(), label,
                style);
    if (shown_.can_edit) DrawXmlGutter(ui_, gutter_, number, row);
    const float end = EndOf(number, row.box);
    list_.PushClipRect({row.box.min.x + (kNumberWidth - 2) * ui_.scale, row.box.min.y},
                       {end, row.box.max.y}, true);
    if (problem) UnderlineProblem(*problem, row.box);
    MarkSelected(number, row.box);
    PaintXmlLine(ui_, TextOf(number), {TextLeft(row.box), row.box.min.y}, row.box);
    DrawCaret(number, row.box);
    list_.PopClipRect();
  }

  // A line that goes on to the right of the tile ends with an ellipsis, which is drawn here.
  float EndOf(std::size_t number, const Box& box) {
    const float width = XmlColumn(ui_, TextOf(number), TextOf(number).size());
    widest_ = std::max(widest_, width);
    if (TextLeft(box) + width <= box.max.x) return box.max.x;
    const TextStyle style{Face::kSans, 11, ui_.palette.text_dim};
    const float end = box.max.x - ui_.Width(icon::kEllipsis, style) - 4 * ui_.scale;
    ui_.RowText(list_, {end + 2 * ui_.scale, box.min.y}, box.height(), icon::kEllipsis, style);
    return end;
  }

  void MarkNode(std::size_t number, const Box& box) {
    if (shown_.end == 0 || lines_[number].end < shown_.begin ||
        lines_[number].begin >= shown_.end) {
      return;
    }
    ui_.Fill(list_, box, Fade(ui_.palette.accent, 0.11F));
    ui_.Fill(list_, {box.min, {box.min.x + 3 * ui_.scale, box.max.y}}, ui_.palette.accent);
  }

  // The gravest of the line.
  const Diagnostic* ProblemOf(std::size_t number) const {
    const Diagnostic* found = nullptr;
    for (const Diagnostic* problem : problems_) {
      if (problem->where.line != number + 1) continue;
      if (!found || problem->severity == Severity::kError) found = problem;
    }
    return found;
  }

  void MarkProblem(const Diagnostic& problem, const Row& row) {
    const bool error = problem.severity == Severity::kError;
    const Color color = error ? ui_.palette.error : ui_.palette.warning;
    ui_.Fill(list_, {row.box.min, {row.box.min.x + 3 * ui_.scale, row.box.max.y}}, color);
    ui_.items.Add("xml/problem/" + std::to_string(problem.where.line), row.box);
    if (row.hovered) Tooltip(ui_, problem.message);
  }

  void UnderlineProblem(const Diagnostic& problem, const Box& box) {
    const bool error = problem.severity == Severity::kError;
    const std::size_t number = problem.where.line - 1;
    const std::size_t column = problem.where.column > 0 ? problem.where.column - 1 : 0;
    const float from = TextLeft(box) + XmlColumn(ui_, TextOf(number), column);
    const float to = TextLeft(box) + XmlColumn(ui_, TextOf(number), TextOf(number).size());
    const float y = box.max.y - 2 * ui_.scale;
    ui_.Fill(list_, {{from, y}, {std::max(to, from + 12 * ui_.scale), y + ui_.scale}},
             error ? ui_.palette.error : ui_.palette.warning);
  }

  void MarkSelected(std::size_t number, const Box& box) {
    const std::size_t begin = std::min(pane_.at, pane_.anchor);
    const std::size_t end = std::max(pane_.at, pane_.anchor);
    const Line& line = lines_[number];
    if (!pane_.focused || begin == end || end <= line.begin || begin > line.end) return;
    const float left = TextLeft(box);
    const auto at = [&](std::size_t offset) {
      const std::size_t inside = std::clamp<std::size_t>(offset, line.begin, line.end);
      return left + XmlColumn(ui_, TextOf(number), inside - line.begin);
    };
    const float more = end > line.end ? 6 * ui_.scale : 0;  // the line end is selected too
    ui_.Fill(list_, {{at(begin), box.min.y}, {at(end) + more, box.max.y}},
             Fade(ui_.palette.accent, 0.35F));
  }

  void DrawCaret(std::size_t number, const Box& box) {
    if (!pane_.focused || number != LineOf(pane_.at)) return;
    const float x = TextLeft(box) + XmlColumn(ui_, TextOf(number), pane_.at - lines_[number].begin);
    const Box caret = {{x, box.min.y + 1}, {x + 1.5F * ui_.scale, box.max.y - 1}};
    ui_.Fill(list_, caret, ui_.palette.text);
    ui_.items.Add("xml/caret", caret);
  }

  // A press sets the caret, dragging selects, a double click selects a word.
  void Mouse() {
    const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (over) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    const bool pressed = over && ImGui::IsMouseClicked(0);
    const bool dragged = pane_.focused && pane_.pressed && ImGui::IsMouseDown(0);
    if (!pressed && !dragged) {
      pane_.pressed = false;
      return;
    }
    const std::size_t at = OffsetAtMouse();
    if (pressed) pane_.focused = pane_.pressed = true;
    if (at == pane_.at && !pressed) return;
    pane_.at = at;
    if (pressed && !ImGui::GetIO().KeyShift) pane_.anchor = at;
    if (ImGui::IsMouseDoubleClicked(0)) SelectWord();
  }

  std::size_t OffsetAtMouse() const {
    const Point mouse = FromIm(ImGui::GetIO().MousePos);
    const float row = (mouse.y - first_y_) / (kLineHeight * ui_.scale);
    const auto last = static_cast<float>(lines_.size() - 1);
    const auto number = static_cast<std::size_t>(std::clamp(row, 0.0F, last));
    const float left = ImGui::GetWindowPos().x + kNumberWidth * ui_.scale - pane_.left;
    return lines_[number].begin + XmlByteAt(ui_, TextOf(number), mouse.x - left);
  }

  void SelectWord() {
    TextEdit edit{*shown_.text, pane_.at, pane_.at};
    edit.Move(TextStep::kWordRight, false);
    edit.Move(TextStep::kWordLeft, true);
    pane_.anchor = edit.at;
    pane_.at = edit.anchor;
  }

  const Ui& ui_;
  XmlPane& pane_;
  const XmlGutter& gutter_;
  const ShownXml& shown_;
  const std::vector<Line>& lines_;
  ImDrawList& list_;
  std::vector<const Diagnostic*> problems_;
  float first_y_ = 0;
  float widest_ = 0;  // of the lines that are drawn
};

std::string TitleOf(const ShownXml& shown) {
  return shown.text ? "XML  " + shown.path.substr(shown.path.rfind('/') + 1) : "XML";
}

std::string NoteOf(const EditorState& state, const ShownXml& shown) {
  if (!shown.text) return "";
  if (!shown.can_edit) return "read only";
  return state.xml.pane.focused ? "Esc to stop typing" : "click to type";
}

// A click elsewhere ends typing; a command begins it at the selected node.
void PassFocus(EditorState& state, const ShownXml& shown, const Box& box) {
  XmlPane& pane = state.xml.pane;
  if (pane.path != shown.path) {
    const bool wanted = pane.wants_focus;
    pane = {};
    pane.path = shown.path;
    pane.wants_focus = wanted;
  }
  if (std::exchange(pane.wants_focus, false)) {
    pane.focused = pane.follow = true;
    pane.at = pane.anchor = shown.begin;
  }
  const bool elsewhere = ImGui::IsMouseClicked(0) && !box.Contains(FromIm(ImGui::GetIO().MousePos));
  if (elsewhere || !shown.can_edit || state.popup.kind != Popup::kNone) pane.focused = false;
  pane.at = std::min(pane.at, shown.text->size());
  pane.anchor = std::min(pane.anchor, shown.text->size());
}

}  // namespace

void DrawXml(const Ui& ui, EditorState& state, const Box& box) {
  ShownXml shown = ChooseXml(state, state.workspace.view());
  if (shown.text) PassFocus(state, shown, box);
  if (shown.text && state.xml.pane.focused) {
    XmlTyping(ui, state, shown).Run();
    shown = ChooseXml(state, state.workspace.view());  // what has become of it
  }
  if (shown.can_edit) UpdateXmlGutter(state, shown.path);
  Panel(ui, "xml", box, TitleOf(shown), NoteOf(state, shown), [&] {
    if (shown.text) {
      XmlPanel(ui, state, shown).Draw();
    } else {
      Hint(ui, "The text of the shown tree, to read and to edit. Ctrl+O opens a file.");
    }
  });
}

}  // namespace coppice::editor
