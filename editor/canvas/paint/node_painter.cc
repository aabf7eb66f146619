// A node is painted in three degrees of detail, by the zoom: with its ports, with its name alone,
// as a block. What matters most from afar (status, heat, problems, changes) is painted in all
// three, in the same colours.
#include "editor/canvas/paint/node_painter.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/layout/value_lines.h"
#include "editor/canvas/paint/node_lines.h"
#include "editor/canvas/paint/node_marks.h"
#include "editor/canvas/paint/status_look.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr double kShimmerSeconds = 1.6;
constexpr float kDisabledPart = 0.8F;  // how much of the ground comes through a pale header
constexpr float kSmallestName = 9;     // of one that fits
constexpr float kOverhang = 2;         // pixels of a name that may stand over its room
constexpr float kLeastName = 6.3F;     // of one that would be cut otherwise

double Seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

class NodePainter {
 public:
  NodePainter(Pen& pen, const Scene& scene, const SceneNode& node, const NodeLook& look)
      : pen_(pen),
        ui_(pen.ui),
        scene_(scene),
        node_(node),
        look_(look),
        box_(BodyBox(node, look)) {}

  void Paint() {
    const float before = pen_.opacity;
    pen_.opacity *= look_.strength;
    PaintAll();
    pen_.opacity = before;
  }

 private:
  void PaintAll() {
    if (DetailFor(look_.zoom, ui_.scale) == Detail::kBlock) return PaintBlock();
    const bool name_alone = look_.name_only || DetailFor(look_.zoom, ui_.scale) == Detail::kName;
    PaintBody();
    if (name_alone) PaintNameBody();
    PaintHeat(pen_, look_, box_);
    if (name_alone) {
      PaintName();
    } else {
      PaintTitle();
      PaintNodeLines(pen_, scene_, node_, look_, box_);
    }
    PaintBorder();
    PaintNote(pen_, node_, look_);
    if (node_.disabled) PaintStrike();
    if (look_.collapsed) PaintChip(pen_, look_);
    PaintChange(pen_, look_, box_);
    PaintBadge(pen_, look_, box_);
  }

  float Z(float pixels) const { return pixels * look_.zoom; }
  const Palette& colors() const { return ui_.palette; }
  bool IsPill() const { return node_.shape == Shape::kControl; }

  TextStyle Style(Face face, float size, Color color) const {
    return {face, Z(size) / ui_.scale, color};
  }

  Outline OutlineOf(const Box& box) const {
    switch (node_.shape) {
      case Shape::kControl:
        return RoundedBox(box, Z(metrics::kHeader / 2));
      case Shape::kCondition:
        return CutBox(box, Z(6));
      case Shape::kDecorator:
        return RoundedBox(box, Z(2));
      default:
        return RoundedBox(box, Z(4));
    }
  }

  Box Grown(float pixels) const {
    return {box_.min - Point{pixels, pixels}, box_.max + Point{pixels, pixels}};
  }

  Color StateColor() const {
    Color at_rest = colors().node_border;
    if (look_.badge == Badge::kError) at_rest = colors().error;
    if (look_.change != Change::kNone) at_rest = ColorOf(colors(), look_.change);
    if (node_.disabled && !IsMarked()) at_rest = Mix(at_rest, colors().canvas, 0.5F);
    const Color color = StatusColor(colors(), look_.state, at_rest);
    return look_.offline ? Mix(color, colors().node_border, 0.6F) : color;
  }

  bool IsMarked() const { return look_.badge == Badge::kError || look_.change != Change::kNone; }

  void PaintBlock() {
    const Color at_rest = colors().Of(node_.shape);
    Color color = StatusColor(colors(), look_.state, at_rest);
    if (node_.disabled) color = Mix(color, colors().node_body, kDisabledPart);
    if (IsTrail(look_.state)) color = Mix(at_rest, color, StatusStrength(look_.state, ui_.clock));
    if (look_.has_heat) {
      color = look_.heat < 0 ? colors().node_border : HeatColor(colors(), look_.heat);
    }
    if (look_.change != Change::kNone) color = ColorOf(colors(), look_.change);
    pen_.FillBox(box_, color, std::min(Z(4), 3.0F));
    if (look_.selected) pen_.FrameBox(Grown(2), colors().accent, 3, 2 * ui_.scale);
    PaintBadge(pen_, look_, box_);
  }

  void PaintBody() {
    if (look_.state.status == Status::kRunning && !look_.offline) PaintGlow();
    const bool tall = box_.height() > Z(metrics::kHeader + 1);
    const Outline outline = OutlineOf(box_);
    pen_.Fill(outline, tall ? colors().node_body : HeaderColor());
    const Box header = {box_.min, {box_.max.x, box_.min.y + Z(metrics::kHeader)}};
    if (tall) {
      // The header is the same outline, cut off below the title.
      pen_.PushClip(header);
      pen_.Fill(outline, HeaderColor());
      pen_.PopClip();
    }
    if (node_.shape == Shape::kUnknown) pen_.Hatch(header, Fade(colors().text, 0.10F), Z(8));
    const bool running = look_.state.status == Status::kRunning && !look_.offline;
    if (running && ui_.moves()) PaintShimmer(header);
    const float flash = FlashStrength(look_.state, ui_.clock);
    if (flash > 0 && !ui_.at_rest) pen_.Fill(outline, Fade(0xFFFFFFFF, 0.35F * flash));
    if (flash > 0 && ui_.at_rest) PaintFresh();
  }

  // What is new in the tick that is shown, as long as that stands.
  void PaintFresh() {
    const float side = std::max(Z(9), 6 * ui_.scale);
    const Point at = {box_.min.x, box_.max.y};
    pen_.Fill({{at.x, at.y}, {at.x, at.y - side}, {at.x + side, at.y}}, colors().text);
  }

  // A slanted band of light that walks through the title.
  void PaintShimmer(const Box& header) {
    const auto at = static_cast<float>(std::fmod(ui_.now, kShimmerSeconds) / kShimmerSeconds);
    const float slant = header.height() / 2;
    const float width = Z(22);
    const float x = header.min.x - width + at * (header.width() + 2 * width);
    pen_.PushClip(header);
    pen_.Fill({{x + slant, header.min.y},
               {x + slant + width, header.min.y},
               {x - slant + width, header.max.y},
               {x - slant, header.max.y}},
              Fade(0xFFFFFFFF, 0.10F));
    pen_.PopClip();
  }

  Color HeaderColor() const {
    Color color = colors().Of(node_.shape);
    if (look_.has_heat) color = Mix(color, colors().subtree, 0.6F);
    if (node_.disabled) color = Mix(color, colors().node_body, kDisabledPart);
    return look_.hovered ? Mix(color, 0xFFFFFFFF, 0.08F) : color;
  }

  // Of the name: a pale header needs another one than a full one.
  Color HeaderInk() const { return node_.disabled ? colors().text_dim : colors().text_on_header; }

  void PaintGlow() {
    const float strength = 0.09F + 0.14F * Pulse(ui_);
    pen_.Fill(OutlineOf(Grown(Z(5))), Fade(colors().running, strength));
  }

  void PaintBorder() {
    const bool active = look_.state.status != Status::kIdle;
    const float thick = std::clamp(Z(2.5F), 1.5F * ui_.scale, 4.0F * ui_.scale);
    if (node_.shape == Shape::kSubTree) {
      const Color outer = active ? Fade(StateColor(), 0.6F) : colors().node_border;
      pen_.Stroke(OutlineOf(Grown(Z(3))), outer, ui_.scale);
    }
    const Outline outline = OutlineOf(box_);
    if (active) {
      pen_.Stroke(outline, StateColor(), thick);
    } else if (IsTrail(look_.state)) {
      const Color color = Fade(StateColor(), StatusStrength(look_.state, ui_.clock));
      pen_.Dash(outline, color, thick * 0.75F, Z(5));
    } else if (node_.shape == Shape::kUnknown) {
      pen_.Dash(outline, StateColor(), (IsMarked() ? 2 : 1) * ui_.scale, Z(3));
    } else {
      pen_.Stroke(outline, StateColor(), (IsMarked() ? 2 : 1) * ui_.scale);
    }
    if (look_.selected) {
      const float out = Z(node_.shape == Shape::kSubTree ? 7 : 4);
      pen_.Stroke(OutlineOf(Grown(out)), colors().accent, 2 * ui_.scale);
    }
  }

  void PaintStrike() {
    const float y = box_.min.y + Z(metrics::kHeader / 2);
    const Color ink = HeaderInk();
    pen_.Line({{box_.min.x + Z(metrics::kPad), y}, {box_.max.x - Z(metrics::kPad), y}}, ink,
              std::max(1.0F, Z(1.5F)));
  }

  void PaintTitle() {
    const float height = Z(metrics::kHeader);
    const Color ink = HeaderInk();
    const Point at = box_.min + Point{Z(metrics::kPad), 0};
    const std::string_view glyph = GlyphOf(node_);
    const TextStyle glyph_style = Style(Face::kBold, 12, ink);
    const float middle = at.x + Z(7);
    pen_.RowText({middle - ui_.Width(glyph, glyph_style) / 2, at.y}, height, glyph, glyph_style);
    const Point name_at = at + Point{Z(metrics::kIcon), 0};
    const float room = PaintStatus(height) - name_at.x;
    pen_.RowText(name_at, height, node_.name, Style(Face::kBold, metrics::kTitleSize, ink),
                 std::max(room, 1.0F));
  }

  // From the right: the toggle of a SubTree, or the glyph of the status; then the seconds. Returns
  // where that begins.
  float PaintStatus(float height) {
    float right = box_.max.x - Z(metrics::kPad);
    if (node_.shape == Shape::kSubTree && HasToggle()) {
      PaintToggle();
      right -= Z(metrics::kStatus);
    }
    const bool running = look_.state.status == Status::kRunning;
    const bool has_room = node_.shape != Shape::kControl && node_.shape != Shape::kDecorator;
    if (!running || !has_room || look_.state.since == Time{}) return PaintGlyph(right, height);
    const std::string text = DurationText(Seconds(ui_.clock - look_.state.since));
    const TextStyle style = Style(Face::kSans, 10, HeaderInk());
    if (node_.shape != Shape::kSubTree) {
      PaintGlyph(right, height);
      right -= Z(metrics::kStatus - 3);
    }
    const float left = right - ui_.Width(text, style);
    pen_.RowText({left, box_.min.y}, height, text, style);
    return left;
  }

  bool HasToggle() const { return node_.recursive || node_.end > Index() + 1; }
  std::uint32_t Index() const { return static_cast<std::uint32_t>(&node_ - scene_.nodes.data()); }

  float PaintGlyph(float right, float height) {
    const std::string_view glyph = StatusGlyph(look_.state);
    const float strength = look_.offline ? 0.65F : StatusStrength(look_.state, ui_.clock);
    const TextStyle style = Style(Face::kBold, 12, Fade(HeaderInk(), strength));
    const float left = right - ui_.Width(glyph, style);
    pen_.RowText({left, box_.min.y}, height, glyph, style);
    return left;
  }

  void PaintToggle() {
    const std::string_view glyph =
        look_.collapsed || node_.recursive ? icon::kPlusSquare : icon::kMinusSquare;
    const Box box = ToggleBox(node_, look_);
    const TextStyle style = Style(Face::kSans, 12, Fade(HeaderInk(), 0.7F));
    pen_.RowText({box.center().x - ui_.Width(glyph, style) / 2, box.min.y}, box.height(), glyph,
                 style);
  }

  // Of a node whose name stands alone: all in the colour of the shape.
  void PaintNameBody() {
    pen_.Fill(OutlineOf(box_), HeaderColor());
    if (node_.shape == Shape::kUnknown) pen_.Hatch(box_, Fade(colors().text, 0.10F), Z(8));
  }

  // The name alone is readable far longer than the details. All names are equally large, but for
  // those that would not fit.
  void PaintName() {
    const std::string_view sign = StatusGlyph(look_.state);
    const TextStyle sign_style{Face::kBold, 8, HeaderInk()};
    const float inset = IsPill() ? std::max(3.0F, Z(metrics::kHeader / 4)) : 3;
    Box room = {box_.min + Point{inset, 0}, box_.max - Point{inset, 0}};
    if (HasGlyphBesideName(node_)) PaintGlyphBesideName(room);
    if (!sign.empty()) room.max.x -= ui_.Width(sign, sign_style) + 2;
    const float right = PaintNameIn(room);
    if (!sign.empty()) pen_.RowText({right + 2, box_.min.y}, box_.height(), sign, sign_style);
  }

  // In one or two lines. Returns where they end.
  float PaintNameIn(const Box& room) {
    const float wished = std::max(Z(metrics::kNameAloneSize) / ui_.scale, kSmallestName);
    const float high = room.height() / ui_.scale;
    TextStyle style{Face::kBold, std::min(wished, high * 0.85F), HeaderInk()};
    NameLines lines = {node_.name, {}};
    if (look_.name_only || ui_.Width(node_.name, style) > room.width()) {
      lines = BreakName(node_.name);
      if (!lines.second.empty()) style.size = std::min(wished, high * 0.46F);
    }
    const auto widest = [&] {
      return std::max(ui_.Width(lines.first, style), ui_.Width(lines.second, style));
    };
    if (widest() > room.width()) {
      style.size = std::max(kLeastName, style.size * room.width() / widest());
    }
    // Letters are not narrower in proportion: their widths are whole pixels.
    while (widest() > room.width() + kOverhang && style.size > kLeastName) style.size -= 0.25F;
    const float height = lines.second.empty() ? room.height() : room.height() / 2;
    PaintLine(lines.first, {room.min, {room.max.x, room.min.y + height}}, style);
    PaintLine(lines.second, {{room.min.x, room.max.y - height}, room.max}, style);
    return room.center().x + std::min(widest(), room.width()) / 2;
  }

  void PaintLine(std::string_view text, const Box& row, const TextStyle& style) {
    const float width = std::min(ui_.Width(text, style), row.width());
    pen_.RowText({row.center().x - width / 2, row.min.y}, row.height(), text, style,
                 row.width() + kOverhang);
  }

  // At the left side of the room, which becomes smaller.
  void PaintGlyphBesideName(Box& room) {
    const std::string_view glyph = GlyphOf(node_);
    const float size = std::max(Z(metrics::kTitleSize) / ui_.scale, kSmallestName);
    const TextStyle style{Face::kBold, size, Fade(HeaderInk(), 0.8F)};
    const float width = ui_.Width(glyph, style);
    pen_.RowText({room.min.x + Z(2), box_.min.y}, box_.height(), glyph, style);
    room.min.x += std::max(width + Z(2), Z(metrics::kNameAloneGlyph - metrics::kNameAlonePad / 2));
  }

  Pen& pen_;
  const Ui& ui_;
  const Scene& scene_;
  const SceneNode& node_;
  const NodeLook& look_;
  Box box_;
};

}  // namespace

Detail DetailFor(float zoom, float screen_scale) {
  if (zoom > 0.6F * screen_scale) return Detail::kFull;
  return zoom >= 0.3F * screen_scale ? Detail::kName : Detail::kBlock;
}

void PaintNode(Pen& pen, const Scene& scene, const SceneNode& node, const NodeLook& look) {
  NodePainter(pen, scene, node, look).Paint();
}

Box BodyBox(const SceneNode& node, const NodeLook& look) {
  Box box = look.box;
  box.min.y += NoteHeight(node, look.name_only) * look.zoom;
  if (look.collapsed) box.max.y -= metrics::kChip * look.zoom;
  return box;
}

Box ToggleBox(const SceneNode& node, const NodeLook& look) {
  const float right = look.box.max.x - 5 * look.zoom;
  const float top = look.box.min.y + (NoteHeight(node, look.name_only) + 3) * look.zoom;
  return {{right - 18 * look.zoom, top}, {right, top + 18 * look.zoom}};
}

Box ChipBox(const NodeLook& look) {
  const float width = std::min(look.box.width(), 84 * look.zoom);
  const float center = look.box.center().x;
  const float bottom = look.box.max.y;
  return {{center - width / 2, bottom - 16 * look.zoom}, {center + width / 2, bottom}};
}

Box PortBox(const Scene& scene, const SceneNode& node, const NodeLook& look, std::uint32_t port) {
  const Box body = BodyBox(node, look);
  const PortLine& line = scene.ports[node.first_port + port];
  const auto above = static_cast<float>(RowsAbove(scene, node, port, look.whole_values));
  const auto rows = static_cast<float>(ValueLineCount(line, look.whole_values));
  const float top = body.min.y + (metrics::kHeader + 2 + above * metrics::kLine) * look.zoom;
  return {{body.min.x + metrics::kPad * look.zoom, top},
          {body.max.x - metrics::kPad * look.zoom, top + rows * metrics::kLine * look.zoom}};
}

}  // namespace coppice::editor
