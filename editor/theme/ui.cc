#include "editor/theme/ui.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/theme/contrast.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

float WidthIn(const ImFont* font, std::string_view text) {
  if (text.empty()) return 0;  // its data may be null
  return font->CalcTextSizeA(font->FontSize, 1e9F, 0, text.data(), text.data() + text.size()).x;
}

// The longest beginning that fits, at a character's border.
std::size_t FittingLength(const ImFont* font, std::string_view text, float width) {
  const char* rest = nullptr;
  font->CalcTextSizeA(font->FontSize, width, 0, text.data(), text.data() + text.size(), &rest);
  return rest ? static_cast<std::size_t>(rest - text.data()) : text.size();
}

// Of a UTF-8 character: not its first byte.
bool IsInner(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

float Ui::Width(std::string_view text, const TextStyle& style) const {
  return WidthIn(fonts.For(text, style.face, style.size * scale), text);
}

float Ui::ParagraphHeight(std::string_view text, const TextStyle& style, float width) const {
  const ImFont* font = fonts.For(text, style.face, style.size * scale);
  const char* end = text.data() + text.size();
  return font->CalcTextSizeA(font->FontSize, 1e9F, std::max(width, 1.0F), text.data(), end).y;
}

void Ui::Paragraph(ImDrawList& list, Point at, std::string_view text, const TextStyle& style,
                   float width) const {
  const ImFont* font = fonts.For(text, style.face, style.size * scale);
  list.AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, style.color, text.data(),
               text.data() + text.size(), std::max(width, 1.0F));
}

void Ui::Text(ImDrawList& list, Point at, std::string_view text, const TextStyle& style) const {
  if (text.empty()) return;
  const ImFont* font = fonts.For(text, style.face, style.size * scale);
  list.AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, style.color, text.data(),
               text.data() + text.size());
}

std::string Ui::Cut(std::string_view text, const TextStyle& style, float width) const {
  const ImFont* font = fonts.For(text, style.face, style.size * scale);
  if (WidthIn(font, text) <= width) return std::string(text);
  const float dots = WidthIn(font, icon::kEllipsis);
  if (dots > width) return {};
  const std::size_t length = FittingLength(font, text, width - dots);
  return std::string(text.substr(0, length)) + icon::kEllipsis;
}

std::string Ui::CutStart(std::string_view text, const TextStyle& style, float width) const {
  const ImFont* font = fonts.For(text, style.face, style.size * scale);
  const float full = WidthIn(font, text);
  if (full <= width) return std::string(text);
  const float dots = WidthIn(font, icon::kEllipsis);
  if (dots > width) return {};
  std::size_t cut = FittingLength(font, text, full + dots - width);
  while (cut < text.size() &&
         (IsInner(text[cut]) || WidthIn(font, text.substr(cut)) + dots > width)) {
    ++cut;
  }
  return icon::kEllipsis + std::string(text.substr(cut));
}

float Ui::RowText(ImDrawList& list, Point at, float row_height, std::string_view text,
                  const TextStyle& style, float width) const {
  if (text.empty()) return 0;
  const ImFont* font = fonts.For(text, style.face, style.size * scale);
  const Point start = {std::round(at.x), std::round(at.y + (row_height - font->FontSize) / 2)};
  const float full = WidthIn(font, text);
  if (width <= 0 || full <= width) {
    list.AddText(font, font->FontSize, ToIm(start), style.color, text.data(),
                 text.data() + text.size());
    return full;
  }
  const std::string cut = Cut(text, style, width);
  list.AddText(font, font->FontSize, ToIm(start), style.color, cut.data(), cut.data() + cut.size());
  return WidthIn(font, cut);
}

bool Ui::Hit(const std::string& path, const Box& box, bool* hovered) const {
  items.Add(path, box);
  if (hovered) *hovered = false;
  if (box.width() < 1 || box.height() < 1) return false;
  ImGui::SetCursorScreenPos(ToIm(box.min));
  const bool pressed = ImGui::InvisibleButton(path.c_str(), {box.width(), box.height()});
  if (hovered) *hovered = ImGui::IsItemHovered();
  return pressed;
}

bool Ui::Button(const std::string& path, const Box& box, std::string_view text, bool active,
                Color tint) const {
  bool hovered = false;
  const bool pressed = Hit(path, box, &hovered);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Color base = tint     ? Mix(palette.panel, tint, active ? 0.55F : 0.2F)
                     : active ? palette.row_selected
                              : palette.panel;
  Fill(list, box, hovered ? Mix(base, palette.text, 0.08F) : base, 4 * scale);
  Frame(list, box, tint ? Mix(palette.border, tint, 0.7F) : palette.border, 4 * scale);
  const Color writing = active && tint ? WritingOn(base)
                        : active       ? palette.text
                                       : Mix(palette.text_dim, palette.text, 0.5F);
  const TextStyle style{Face::kSans, 12, writing};
  const float width = Width(text, style);
  RowText(list, {box.center().x - width / 2, box.min.y}, box.height(), text, style);
  return pressed;
}

void Ui::Fill(ImDrawList& list, const Box& box, Color color, float rounding) const {
  list.AddRectFilled(ToIm(box.min), ToIm(box.max), color, rounding);
}

void Ui::Frame(ImDrawList& list, const Box& box, Color color, float rounding,
               float thickness) const {
  list.AddRect(ToIm(box.min), ToIm(box.max), color, rounding, 0, thickness > 0 ? thickness : scale);
}

const char* GlyphOf(Status status) {
  switch (status) {
    case Status::kIdle:
      return "";
    case Status::kRunning:
      return icon::kClock;
    case Status::kSuccess:
      return icon::kCheck;
    case Status::kFailure:
      return icon::kTimes;
    case Status::kSkipped:
      return icon::kForward;
  }
  return "";
}

std::string DurationText(double seconds) {
  seconds = std::max(seconds, 0.0);  // clocks of two programs differ a little
  char text[32];
  const auto whole = static_cast<long>(seconds);
  if (seconds < 60) {
    std::snprintf(text, sizeof(text), "%.1f s", seconds);
  } else if (whole < 3600) {
    std::snprintf(text, sizeof(text), "%ld:%02ld", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return text;
}

std::string MillisecondsText(double milliseconds) {
  if (milliseconds >= 999.5) return DurationText(milliseconds / 1000);
  char text[32];
  std::snprintf(text, sizeof(text), "%.*g ms", milliseconds < 100 ? 2 : 3, milliseconds);
  return text;
}

}  // namespace coppice::editor
