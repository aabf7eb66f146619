#include "editor/canvas/paint/node_marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "editor/canvas/layout/node_metrics.h"
#include "editor/canvas/paint/node_painter.h"
#include "editor/canvas/paint/status_look.h"
#include "editor/theme/contrast.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr float kNoteCorner = 12;    // of a node whose name stands alone
constexpr float kNoteTab = 30;       // width of a note without its text, at zoom 1
constexpr float kChangeSquare = 11;  // side of the mark of a change, at scale 1

const char* SignOf(Change change) {
  switch (change) {
    case Change::kAdded:
      return "+";
    case Change::kRemoved:
      return "\u2013";
    case Change::kMoved:
      return icon::kRightArrow;
    case Change::kChanged:
      return "~";
    case Change::kNone:
      break;
  }
  return "";
}

// Only between nodes with their ports is there room for a mark along the whole side.
bool IsBeside(const NodeLook& look, float screen_scale) {
  return !look.name_only && DetailFor(look.zoom, screen_scale) == Detail::kFull;
}

Box ChangeBox(const NodeLook& look, const Box& body, float screen_scale) {
  if (IsBeside(look, screen_scale)) {
    const float wide = std::max(9 * screen_scale, 14 * look.zoom);
    const float right = body.min.x - 2 * look.zoom;
    return {{right - wide, body.min.y}, {right, body.max.y}};
  }
  const float side = kChangeSquare * screen_scale;
  const Point corner = body.min - Point{side, side} * 0.6F;
  return {corner, corner + Point{side, side}};
}

}  // namespace

std::vector<std::string> NoteLines(std::string_view note) {
  std::vector<std::string> lines;
  std::size_t at = 0;
  while (at < note.size() && lines.size() < metrics::kMostNoteLines) {
    std::size_t end = std::min(note.size(), at + metrics::kNoteColumns);
    if (end < note.size() && lines.size() + 1 < metrics::kMostNoteLines) {
      const std::size_t blank = note.rfind(' ', end);
      if (blank != std::string_view::npos && blank > at) end = blank;
    }
    while (end < note.size() && (static_cast<unsigned char>(note[end]) & 0xC0U) == 0x80U) ++end;
    lines.emplace_back(note.substr(at, end - at));
    at = end < note.size() && note[end] == ' ' ? end + 1 : end;
  }
  if (at < note.size()) lines.back() += icon::kEllipsis;
  return lines;
}

namespace {

// A folded corner tells that there is a note.
void PaintNoteTab(Pen& pen, const NodeLook& look) {
  const float side = std::max(kNoteCorner * look.zoom, 5 * pen.ui.scale);
  const Point at = look.box.min;
  pen.Fill({{at.x, at.y}, {at.x + side, at.y}, {at.x, at.y + side}}, pen.ui.palette.note);
}

}  // namespace

void PaintNote(Pen& pen, const SceneNode& node, const NodeLook& look) {
  if (node.note.empty()) return;
  const Palette& colors = pen.ui.palette;
  const float zoom = look.zoom;
  if (look.name_only) return PaintNoteTab(pen, look);
  const float height = NoteHeight(node, false) - metrics::kNoteGap;
  Box box = {look.box.min, {look.box.max.x, look.box.min.y + height * zoom}};
  const bool has_text = DetailFor(zoom, pen.ui.scale) == Detail::kFull;
  if (!has_text) {
    // A tab on the node tells that there is a note.
    box.max.x = std::min(box.max.x, box.min.x + kNoteTab * zoom);
    box.min.y = std::max(box.min.y, box.max.y - kNoteTab / 2 * zoom);
    box.max.y += metrics::kNoteGap * zoom;
  }
  const float fold = std::min(9 * zoom, box.height() / 2);
  // The upper right corner is folded down.
  pen.Fill({{box.min.x, box.min.y},
            {box.max.x - fold, box.min.y},
            {box.max.x, box.min.y + fold},
            {box.max.x, box.max.y},
            {box.min.x, box.max.y}},
           colors.note);
  pen.Fill({{box.max.x - fold, box.min.y},
            {box.max.x, box.min.y + fold},
            {box.max.x - fold, box.min.y + fold}},
           Mix(colors.note, 0xFF000000, 0.25F));
  if (!has_text) return;
  const TextStyle style{Face::kSans, metrics::kNoteSize * zoom / pen.ui.scale, colors.note_text};
  Point at = box.min + Point{6 * zoom, 3 * zoom};
  for (const std::string& line : NoteLines(node.note)) {
    pen.RowText(at, metrics::kNoteLine * zoom, line, style, box.width() - 14 * zoom);
    at.y += metrics::kNoteLine * zoom;
  }
}

void PaintBadge(Pen& pen, const NodeLook& look, const Box& body) {
  const Badge badge = std::max(look.badge, look.collapsed ? look.hidden_badge : Badge::kNone);
  if (badge == Badge::kNone) return;
  const Palette& colors = pen.ui.palette;
  const Color color = badge == Badge::kError ? colors.error : colors.warning;
  const float radius = std::clamp(8 * look.zoom, 4 * pen.ui.scale, 8 * pen.ui.scale);
  const Point center = {body.max.x - radius * 0.3F, body.min.y - radius * 0.1F};
  pen.Disc(center, radius + std::max(1.0F, look.zoom), colors.canvas);
  pen.Disc(center, radius, color);
  const TextStyle style{Face::kBold, radius * 1.5F / pen.ui.scale, WritingOn(color)};
  const char* sign = badge == Badge::kError ? icon::kTimesSign : "!";
  const Point at = {center.x - pen.Width(sign, style) / 2, center.y - radius};
  pen.RowText(at, radius * 2, sign, style);
}

void PaintChip(Pen& pen, const NodeLook& look) {
  const Palette& colors = pen.ui.palette;
  const Box chip = ChipBox(look);
  const bool live = look.hidden_status != Status::kIdle;
  Color stripe = live ? colors.Of(look.hidden_status) : colors.node_border;
  if (!live && look.hidden_badge == Badge::kWarning) stripe = colors.warning;
  if (!live && look.hidden_badge == Badge::kError) stripe = colors.error;
  const float rounding = 4 * look.zoom;
  pen.FillBox(chip, Mix(colors.node_body, stripe, live ? 0.25F : 0.0F), rounding);
  pen.FrameBox(chip, Mix(colors.border, stripe, 0.6F), rounding);
  const std::string text = std::to_string(look.hidden) + (look.hidden == 1 ? " node" : " nodes");
  const TextStyle style{Face::kSans, 10 * look.zoom / pen.ui.scale,
                        live ? colors.text : colors.text_dim};
  pen.RowText({chip.center().x - pen.Width(text, style) / 2, chip.min.y}, chip.height(), text,
              style);
}

void PaintHeat(Pen& pen, const NodeLook& look, const Box& body) {
  if (!look.has_heat) return;
  const Palette& colors = pen.ui.palette;
  if (look.heat < 0) {
    pen.Hatch(body, Fade(0xFF000000, 0.25F), std::max(4.0F, 9 * look.zoom));
    return;
  }
  const float high = std::max(4 * pen.ui.scale, 6 * look.zoom);
  const Box all = {{body.min.x, body.max.y + 2}, {body.max.x, body.max.y + 2 + high}};
  pen.FillBox(all, Fade(colors.node_border, 0.5F));
  const float width = all.width() * std::clamp(look.heat, 0.0F, 1.0F);
  pen.FillBox({all.min, {all.min.x + width, all.max.y}}, HeatColor(colors, look.heat));
}

Color ColorOf(const Palette& palette, Change change) {
  switch (change) {
    case Change::kAdded:
      return palette.success;
    case Change::kRemoved:
      return palette.failure;
    case Change::kMoved:
      return palette.accent;
    case Change::kChanged:
      return palette.changed;
    case Change::kNone:
      break;
  }
  return palette.node_border;
}

void PaintChange(Pen& pen, const NodeLook& look, const Box& body) {
  if (look.change == Change::kNone) return;
  const Palette& colors = pen.ui.palette;
  const Color color = ColorOf(colors, look.change);
  const bool is_square = !IsBeside(look, pen.ui.scale);
  const float size = is_square ? kChangeSquare : std::max(8.0F, 12 * look.zoom / pen.ui.scale);
  const Box stripe = ChangeBox(look, body, pen.ui.scale);
  pen.FillBox(stripe, color, 3 * look.zoom);
  const TextStyle style{Face::kBold, size, WritingOn(color)};
  const char* sign = SignOf(look.change);
  pen.RowText({stripe.center().x - pen.Width(sign, style) / 2, stripe.min.y},
              std::min(stripe.height(), std::max(metrics::kHeader * look.zoom, size * 1.4F)), sign,
              style);
}

void PaintMarks(Pen& pen, const NodeLook& look) {
  const std::uint8_t marks = look.state.marks;
  if (marks == kNoMark) return;
  const Palette& colors = pen.ui.palette;
  const float scale = std::max(look.zoom, 0.6F * pen.ui.scale);
  const Point at = {look.box.min.x - 11 * scale, look.box.center().y};
  if (marks & kStopMark) {
    pen.Disc(at, 9 * scale, colors.running);
    pen.Disc(at, 7.5F * scale, colors.canvas);
    pen.FrameBox({look.box.min - Point{3, 3} * scale, look.box.max + Point{3, 3} * scale},
                 colors.running, 7 * scale, 3 * scale);
  }
  if (marks & (kBreakpointMark | kBreakpointOffMark)) {
    pen.Disc(at, 5.5F * scale, colors.failure);
    if (!(marks & kBreakpointMark)) pen.Disc(at, 3.5F * scale, colors.canvas);
  }
  if (!(marks & kFaultMark)) return;
  const Box flag = {{look.box.min.x, look.box.min.y - 17 * scale},
                    {look.box.min.x + 58 * scale, look.box.min.y - 2 * scale}};
  const Color fault = Mix(colors.canvas, colors.error, 0.8F);
  pen.FillBox(flag, fault, 3 * scale);
  pen.RowText({flag.min.x + 4 * scale, flag.min.y}, flag.height(),
              std::string(icon::kWarning) + " fault",
              {Face::kBold, 10 * scale / pen.ui.scale, WritingOn(fault)}, flag.width() - 6 * scale);
}

}  // namespace coppice::editor
