#include "editor/panels/xml/xml_line.h"

#include <algorithm>
#include <cctype>

namespace coppice::editor {
namespace {

// Paints a piece of a line and moves on by its width.
class LineWriter {
 public:
  LineWriter(const Ui& ui, Point at, const Box& row) : ui_(ui), at_(at), row_(row) {}

  bool IsFull() const { return at_.x > row_.max.x; }

  void Write(std::string_view text, Color color) {
    const TextStyle style{kXmlStyle.face, kXmlStyle.size, color};
    at_.x += ui_.RowText(*ImGui::GetWindowDrawList(), at_, row_.height(), text, style);
  }

 private:
  const Ui& ui_;
  Point at_;
  const Box row_;
};

bool IsTagCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '/' || c == '_' || c == '?';
}

}  // namespace

void PaintXmlLine(const Ui& ui, std::string_view line, Point at, const Box& row) {
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
      while (end < line.size() && IsTagCharacter(line[end])) ++end;
      write_until(end, colors.accent);
    } else if (line[i] == '"') {
      const std::size_t end = line.find('"', i + 1);
      write_until(end == std::string_view::npos ? line.size() : end + 1, colors.link);
    } else {
      write_until(std::max(line.find_first_of("<\"", i), i + 1), colors.text);
    }
  }
}

float XmlColumn(const Ui& ui, std::string_view line, std::size_t byte) {
  return ui.Width(line.substr(0, std::min(byte, line.size())), kXmlStyle);
}

std::size_t XmlByteAt(const Ui& ui, std::string_view line, float x) {
  std::size_t best = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const bool inner = i < line.size() && (static_cast<unsigned char>(line[i]) & 0xC0U) == 0x80U;
    if (inner) continue;
    const float here = XmlColumn(ui, line, i);
    if (std::abs(here - x) <= std::abs(XmlColumn(ui, line, best) - x)) best = i;
    if (here > x) break;
  }
  return best;
}

}  // namespace coppice::editor
