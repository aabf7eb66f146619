#include <algorithm>
#include <cctype>

#include "editor/panels/panel.h"
#include "editor/panels/panels.h"

namespace coppice::editor {
namespace {

constexpr float kLineHeight = 18;
constexpr float kNumberWidth = 44;

std::vector<std::string_view> SplitLines(const std::string& text) {
  std::vector<std::string_view> lines;
  std::size_t start = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', start)) {
    lines.push_back(std::string_view(text).substr(start, end - start));
    start = end + 1;
  }
  if (start < text.size()) lines.push_back(std::string_view(text).substr(start));
  return lines;
}

// Paints a piece of a line and moves on by its width.
class LineWriter {
 public:
  LineWriter(const Ui& ui, Point at, const Box& row) : ui_(ui), at_(at), row_(row) {}

  bool IsFull() const { return at_.x > row_.max.x; }

  void Write(std::string_view text, Color color) {
    const TextStyle style{Face::kMono, 11, color};
    at_.x += ui_.RowText(*ImGui::GetWindowDrawList(), at_, row_.height(), text, style);
  }

 private:
  const Ui& ui_;
  Point at_;
  const Box row_;
};

// Tags, values and comments in colours of their own; one line at a time, so a comment over several
// lines is coloured in its first line only.
void PaintLine(const Ui& ui, std::string_view line, Point at, const Box& row) {
  LineWriter writer(ui, at, row);
  const Palette& colors = ui.palette;
  std::size_t i = 0;
  const auto write_until = [&](std::size_t end, Color color) {
    end = std::min(end, line.size());
    writer.Write(line.substr(i, end - i), color);
    i = end;
  };
  while (i < line.size() && !writer.IsFull()) {
    if (line.compare(i, 4, "<!--") == 0) {
      const std::size_t end = line.find("-->", i);
      write_until(end == std::string_view::npos ? line.size() : end + 3, colors.text_dim);
    } else if (line[i] == '<') {
      std::size_t end = i + 1;
      while (end < line.size() && (std::isalnum(static_cast<unsigned char>(line[end])) ||
                                   line[end] == '/' || line[end] == '_')) {
        ++end;
      }
      write_until(end, colors.accent);
    } else if (line[i] == '"') {
      const std::size_t end = line.find('"', i + 1);
      write_until(end == std::string_view::npos ? line.size() : end + 1, colors.link);
    } else {
      write_until(std::max(line.find_first_of("<\"", i), i + 1), colors.text);
    }
  }
}

struct Shown {
  std::string title;
  const std::string* text = nullptr;
  std::uint32_t line = 0;       ///< to highlight, from 1; 0: none
  std::uint32_t last_line = 0;  ///< of the start tag
  bool error = false;
};

// The document of the selected node, else of the shown tree; of a file without trees its text.
Shown Choose(const Workspace& workspace, const TreeView* view) {
  Shown shown;
  const Forest* forest = workspace.forest();
  if (forest && view) {
    const bool selected = view->selected() != kNoNode;
    const SceneNode& node = view->scene()->nodes[selected ? view->selected() : 0];
    const Document& document = *forest->documents()[node.document];
    shown.title = document.file().substr(document.file().rfind('/') + 1);
    shown.text = &document.text();
    if (selected) {
      const Element& element = document.element(node.element);
      shown.line = document.Location(element.offset).line;
      const std::size_t end = document.text().find('>', element.offset);
      shown.last_line =
          document.Location(static_cast<std::uint32_t>(std::min(end, document.text().size() - 1)))
              .line;
    }
    return shown;
  }
  const OpenFile* file = workspace.file();
  if (!file) return shown;
  shown.title = file->path.substr(file->path.rfind('/') + 1);
  shown.text = &file->text;
  for (const Diagnostic& problem : file->problems) {
    if (problem.where.file == file->path && shown.line == 0) {
      shown.line = shown.last_line = problem.where.line;
      shown.error = true;
    }
  }
  return shown;
}

void FollowLine(const Ui& ui, const Shown& shown) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID(shown.title.c_str());
  if (storage.GetInt(id, -1) == static_cast<int>(shown.line)) return;
  storage.SetInt(id, static_cast<int>(shown.line));
  if (shown.line == 0) return;
  const float middle = static_cast<float>(shown.line) * kLineHeight * ui.scale;
  ImGui::SetScrollY(std::max(0.0F, middle - ImGui::GetWindowHeight() / 2));
}

void DrawLines(const Ui& ui, const Shown& shown) {
  const std::vector<std::string_view> lines = SplitLines(*shown.text);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines.size()), kLineHeight * ui.scale);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto number = static_cast<std::uint32_t>(i) + 1;
      const Row row = NextRow(ui, "xml/" + std::to_string(number), false, kLineHeight);
      if (!row.visible) continue;
      ImDrawList& list = *ImGui::GetWindowDrawList();
      if (number >= shown.line && number <= shown.last_line) {
        const Color color = shown.error ? ui.palette.error : ui.palette.accent;
        ui.Fill(list, row.box, Fade(color, 0.18F));
        ui.Fill(list, {row.box.min, {row.box.min.x + 3, row.box.max.y}}, color);
      }
      const std::string text = std::to_string(number);
      const TextStyle style{Face::kMono, 11, Fade(ui.palette.text_dim, 0.8F)};
      const float right = row.box.min.x + (kNumberWidth - 14) * ui.scale;
      ui.RowText(list, {right - ui.Width(text, style), row.box.min.y}, row.box.height(), text,
                 style);
      PaintLine(ui, lines[static_cast<std::size_t>(i)],
                row.box.min + Point{kNumberWidth * ui.scale, 0}, row.box);
    }
  }
}

}  // namespace

void DrawXml(const Ui& ui, EditorState& state, const Box& box) {
  const Shown shown = Choose(state.workspace, state.workspace.view());
  const std::string title = shown.title.empty() ? "XML" : "XML  " + shown.title;
  Panel(ui, "xml", box, title, "read only", [&] {
    if (!shown.text) {
      Hint(ui, "The text of the shown tree.");
      return;
    }
    FollowLine(ui, shown);
    DrawLines(ui, shown);
  });
}

}  // namespace coppice::editor
