#include "editor/panels/xml/xml_gutter.h"

namespace coppice::editor {
namespace {

constexpr float kBar = 3;
constexpr float kUnsavedAt = 12;  // from the text, to the left
constexpr float kUncommittedAt = 7;

LineMark MarkOf(const std::vector<LineMark>& marks, std::size_t line) {
  return line < marks.size() ? marks[line] : LineMark::kSame;
}

const char* WordsFor(LineMark mark) {
  return mark == LineMark::kAdded     ? "new"
         : mark == LineMark::kChanged ? "changed"
                                      : "lines were removed";
}

// Added lines have a full bar, changed ones a hatched one; where lines are gone there is a wedge:
// the shape says it without the colour.
void PaintMark(const Ui& ui, ImDrawList& list, const Box& bar, LineMark mark, Color color) {
  const float unit = ui.scale;
  switch (mark) {
    case LineMark::kSame:
      break;
    case LineMark::kAdded:
      ui.Fill(list, bar, color);
      break;
    case LineMark::kChanged:
      for (float y = bar.min.y; y + 2 * unit <= bar.max.y; y += 3 * unit) {
        ui.Fill(list, {{bar.min.x, y}, {bar.max.x, y + 2 * unit}}, color);
      }
      break;
    case LineMark::kRemoved:
      list.AddTriangleFilled({bar.min.x - unit, bar.min.y - 3 * unit},
                             {bar.min.x - unit, bar.min.y + 3 * unit},
                             {bar.max.x + unit, bar.min.y}, color);
      break;
  }
}

}  // namespace

void UpdateXmlGutter(EditorState& state, const std::string& path) {
  XmlGutter& gutter = state.xml.gutter;
  const EditedFile* file = state.workspace.project().Find(path);
  if (!file) return;
  const std::shared_ptr<const std::string> head = file->is_new ? nullptr : state.git.TextOf(path);
  const bool is_known = gutter.path == path && gutter.version == file->version &&
                        gutter.head == head && gutter.saved_version == file->saved_version;
  if (is_known) return;
  gutter = {path, file->version, file->saved_version, head, {}, {}};
  if (!file->is_new) gutter.since_saved = MarkLines(file->saved, file->text);
  if (head) gutter.since_head = MarkLines(*head, file->text);
}

void DrawXmlGutter(const Ui& ui, const XmlGutter& gutter, std::size_t line, const Row& row) {
  const LineMark unsaved = MarkOf(gutter.since_saved, line);
  const LineMark uncommitted = MarkOf(gutter.since_head, line);
  if (unsaved == LineMark::kSame && uncommitted == LineMark::kSame) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float text = row.box.min.x + kXmlNumberWidth * ui.scale;
  const auto bar = [&](float from_text) {
    const float x = text - from_text * ui.scale;
    return Box{{x, row.box.min.y}, {x + kBar * ui.scale, row.box.max.y}};
  };
  const std::string number = std::to_string(line + 1);
  std::string words;
  if (unsaved != LineMark::kSame) {
    PaintMark(ui, list, bar(kUnsavedAt), unsaved, ui.palette.warning);
    ui.items.Add("xml/unsaved/" + number, bar(kUnsavedAt));
    words = std::string("not saved: ") + WordsFor(unsaved);
  }
  if (uncommitted != LineMark::kSame) {
    PaintMark(ui, list, bar(kUncommittedAt), uncommitted, ui.palette.accent);
    ui.items.Add("xml/uncommitted/" + number, bar(kUncommittedAt));
    words += std::string(words.empty() ? "" : "\n") + "not committed: " + WordsFor(uncommitted);
  }
  const float mouse = ImGui::GetIO().MousePos.x;
  if (row.hovered && mouse >= bar(kUnsavedAt).min.x - ui.scale && mouse < text) {
    Tooltip(ui, words);
  }
}

}  // namespace coppice::editor
