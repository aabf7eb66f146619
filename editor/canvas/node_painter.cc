#include "editor/canvas/node_painter.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/shapes.h"
#include "editor/look/icons.h"

namespace coppice::editor {
namespace {

constexpr double kPulseSeconds = 0.8;
constexpr double kFlashSeconds = 0.4;
constexpr float kTrailAlpha = 0.7F;

double Seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

class NodePainter {
 public:
  NodePainter(const Ui& ui, ImDrawList& list, const Scene& scene, const SceneNode& node,
              const NodeLook& look)
      : ui_(ui), list_(list), scene_(scene), node_(node), look_(look), box_(look.box) {
    if (look.collapsed) box_.max.y -= metrics::kChip * look.zoom;
  }

  void Paint() {
    switch (DetailFor(look_.zoom)) {
      case Detail::kBlock:
        PaintBlock();
        return;
      case Detail::kName:
        PaintBody();
        PaintBorder();
        PaintName();
        break;
      case Detail::kFull:
        PaintBody();
        PaintBorder();
        PaintTitle();
        PaintLines();
        break;
    }
    if (look_.collapsed) PaintChip();
  }

 private:
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
    const Color color = StatusColor(colors(), look_.state, colors().node_border);
    return look_.offline ? Mix(color, colors().node_border, 0.6F) : color;
  }

  bool IsTrail() const {
    return look_.state.status == Status::kIdle && look_.state.before != Status::kIdle;
  }

  void PaintBlock() {
    const Color at_rest = colors().Of(node_.shape);
    Color color = StatusColor(colors(), look_.state, at_rest);
    if (IsTrail()) color = Mix(color, at_rest, 0.5F);
    ui_.Fill(list_, box_, color, std::min(Z(4), 3.0F));
    if (look_.selected) ui_.Frame(list_, Grown(2), colors().accent, 3, 2);
  }

  void PaintBody() {
    if (look_.state.status == Status::kRunning && !look_.offline) PaintGlow();
    const bool tall = box_.height() > Z(metrics::kHeader + 1);
    const Outline outline = OutlineOf(box_);
    FillOutline(list_, outline, tall ? colors().node_body : HeaderColor());
    if (tall) {
      // The header is the same outline, cut off below the title.
      list_.PushClipRect(ToIm(box_.min), {box_.max.x, box_.min.y + Z(metrics::kHeader)}, true);
      FillOutline(list_, outline, HeaderColor());
      list_.PopClipRect();
    }
    if (node_.shape == Shape::kUnknown) {
      Hatch(list_, {box_.min, {box_.max.x, box_.min.y + Z(metrics::kHeader)}},
            Fade(colors().text, 0.10F), Z(8));
    }
    PaintFlash(outline);
  }

  Color HeaderColor() const {
    const Color color = colors().Of(node_.shape);
    return look_.hovered ? Mix(color, 0xFFFFFFFF, 0.08F) : color;
  }

  void PaintGlow() {
    const double phase = std::fmod(ui_.now, kPulseSeconds) / kPulseSeconds * 6.2831853;
    const auto strength = static_cast<float>(0.16 + 0.07 * std::sin(phase));
    FillOutline(list_, OutlineOf(Grown(Z(5))), Fade(colors().running, strength));
  }

  void PaintFlash(const Outline& outline) {
    const double age = Seconds(ui_.clock - look_.state.since) / kFlashSeconds;
    if (look_.state.since == Time(0) || age < 0 || age >= 1) return;
    const auto left = static_cast<float>(1 - age);
    FillOutline(list_, outline, Fade(0xFFFFFFFF, 0.35F * left * left));
  }

  void PaintBorder() {
    const bool active = look_.state.status != Status::kIdle;
    const float thick = std::clamp(Z(2.5F), 1.5F, 4.0F);
    if (node_.shape == Shape::kSubTree) {
      const Color outer = active ? Fade(StateColor(), 0.6F) : colors().node_border;
      StrokeOutline(list_, OutlineOf(Grown(Z(3))), outer, 1);
    }
    if (active) {
      StrokeOutline(list_, OutlineOf(box_), StateColor(), thick);
    } else if (IsTrail()) {
      DashOutline(list_, OutlineOf(box_), Fade(StateColor(), kTrailAlpha), thick * 0.75F, Z(5));
    } else if (node_.shape == Shape::kUnknown) {
      DashOutline(list_, OutlineOf(box_), StateColor(), 1, Z(3));
    } else {
      StrokeOutline(list_, OutlineOf(box_), StateColor(), 1);
    }
    if (look_.selected) {
      const float out = Z(node_.shape == Shape::kSubTree ? 7 : 4);
      StrokeOutline(list_, OutlineOf(Grown(out)), colors().accent, 2);
    }
  }

  void PaintTitle() {
    const float height = Z(metrics::kHeader);
    const Color ink = colors().text_on_header;
    const Point at = box_.min + Point{Z(metrics::kPad), 0};
    const std::string_view glyph = GlyphOf(node_);
    const TextStyle glyph_style = Style(Face::kBold, 12, Fade(ink, 0.92F));
    const float middle = at.x + Z(7);
    ui_.RowText(list_, {middle - ui_.Width(glyph, glyph_style) / 2, at.y}, height, glyph,
                glyph_style);
    ui_.RowText(list_, at + Point{Z(metrics::kIcon), 0}, height, node_.name,
                Style(Face::kBold, metrics::kTitleSize, ink));
    PaintStatus(height);
  }

  // From the right: the toggle of a SubTree, or the glyph of the status; then the seconds.
  void PaintStatus(float height) {
    float right = box_.max.x - Z(metrics::kPad);
    if (node_.shape == Shape::kSubTree && HasToggle()) {
      PaintToggle();
      right -= Z(metrics::kStatus);
    }
    const bool running = look_.state.status == Status::kRunning;
    const bool has_room = node_.shape != Shape::kControl && node_.shape != Shape::kDecorator;
    if (!running || !has_room || look_.state.since == Time(0)) return PaintGlyph(right, height);
    const std::string text = DurationText(Seconds(ui_.clock - look_.state.since));
    const TextStyle style = Style(Face::kSans, 10, colors().text_on_header);
    if (node_.shape != Shape::kSubTree) {
      PaintGlyph(right, height);
      right -= Z(metrics::kStatus - 3);
    }
    ui_.RowText(list_, {right - ui_.Width(text, style), box_.min.y}, height, text, style);
  }

  bool HasToggle() const { return node_.recursive || node_.end > Index() + 1; }
  std::uint32_t Index() const { return static_cast<std::uint32_t>(&node_ - scene_.nodes.data()); }

  void PaintGlyph(float right, float height) {
    const Status status = IsTrail() ? look_.state.before : look_.state.status;
    const std::string_view glyph = GlyphOf(status);
    const float strength = IsTrail() || look_.offline ? 0.65F : 1.0F;
    const TextStyle style = Style(Face::kBold, 12, Fade(colors().text_on_header, strength));
    ui_.RowText(list_, {right - ui_.Width(glyph, style), box_.min.y}, height, glyph, style);
  }

  void PaintToggle() {
    const std::string_view glyph =
        look_.collapsed || node_.recursive ? icon::kPlusSquare : icon::kMinusSquare;
    const Box box = ToggleBox(look_);
    const TextStyle style = Style(Face::kSans, 12, Fade(colors().text_on_header, 0.7F));
    ui_.RowText(list_, {box.center().x - ui_.Width(glyph, style) / 2, box.min.y}, box.height(),
                glyph, style);
  }

  void PaintLines() {
    float y = box_.min.y + Z(metrics::kHeader) + Z(2);
    const float x = box_.min.x + Z(metrics::kPad);
    const std::string_view type = TypeLineOf(node_);
    if (!type.empty()) {
      ui_.RowText(list_, {x, y}, Z(metrics::kLine), type,
                  Style(Face::kSans, metrics::kNameSize, Fade(colors().text_dim, 0.9F)));
      y += Z(metrics::kLine);
    }
    const float column = Z(NameColumn(ui_, scene_, node_) / ui_.scale + metrics::kColumnGap);
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      PaintPort(scene_.ports[node_.first_port + i], {x, y}, column);
      y += Z(metrics::kLine);
    }
  }

  void PaintPort(const PortLine& port, Point at, float column) {
    ui_.RowText(list_, at, Z(metrics::kLine), port.name,
                Style(Face::kSans, metrics::kNameSize, colors().text_dim));
    const Point value_at = at + Point{column, 0};
    const std::string value = ShownValue(port.value);
    if (!port.is_key) {
      ui_.RowText(list_, value_at, Z(metrics::kLine), value,
                  Style(Face::kMono, metrics::kValueSize, colors().text));
      return;
    }
    const Color key = colors().OfKey(KeyOf(port.value));
    const TextStyle style = Style(Face::kMono, metrics::kValueSize, key);
    const float width = ui_.Width(value, style);
    const Box chip = {value_at + Point{0, Z(2)},
                      value_at + Point{width + Z(10), Z(metrics::kLine - 2)}};
    ui_.Fill(list_, chip, Mix(colors().node_body, key, 0.16F), Z(4));
    ui_.Frame(list_, chip, Mix(colors().node_body, key, 0.5F), Z(4));
    ui_.RowText(list_, value_at + Point{Z(5), 0}, Z(metrics::kLine), value, style);
  }

  // The name as large as the box allows, so that it is readable far longer than the details.
  void PaintName() {
    const float room = box_.width() - 6;
    const float largest = std::min(10.0F, box_.height() * 0.7F / ui_.scale);
    const Color ink =
        box_.height() > Z(metrics::kHeader + 1) ? colors().text : colors().text_on_header;
    TextStyle style{Face::kBold, largest, ink};
    const float wanted = ui_.Width(node_.name, style);
    if (wanted > room) style.size = std::max(7.0F, largest * room / wanted);
    const float width = std::min(ui_.Width(node_.name, style), room);
    const bool tall = box_.height() > Z(metrics::kHeader + 1);
    const float top = tall ? box_.min.y + Z(metrics::kHeader) : box_.min.y;
    ui_.RowText(list_, {box_.center().x - width / 2, top}, box_.max.y - top, node_.name, style,
                room);
    if (!tall) return;
    const TextStyle glyph{Face::kBold, Z(14) / ui_.scale, colors().text_on_header};
    ui_.RowText(list_, box_.min + Point{4, 0}, Z(metrics::kHeader), GlyphOf(node_), glyph);
    PaintGlyph(box_.max.x - 4, Z(metrics::kHeader));
  }

  void PaintChip() {
    const Box chip = ChipBox(look_);
    const bool live = look_.hidden_status != Status::kIdle;
    const Color stripe = live ? colors().Of(look_.hidden_status) : colors().node_border;
    ui_.Fill(list_, chip, Mix(colors().node_body, stripe, live ? 0.25F : 0.0F), Z(4));
    ui_.Frame(list_, chip, Mix(colors().border, stripe, 0.6F), Z(4));
    const std::string text = std::to_string(look_.hidden) + " nodes";
    const TextStyle style = Style(Face::kSans, 10, live ? colors().text : colors().text_dim);
    const float width = ui_.Width(text, style);
    ui_.RowText(list_, {chip.center().x - width / 2, chip.min.y}, chip.height(), text, style);
  }

  const Ui& ui_;
  ImDrawList& list_;
  const Scene& scene_;
  const SceneNode& node_;
  const NodeLook& look_;
  Box box_;
};

}  // namespace

Detail DetailFor(float zoom) {
  if (zoom > 0.6F) return Detail::kFull;
  return zoom >= 0.3F ? Detail::kName : Detail::kBlock;
}

Color StatusColor(const Palette& palette, const NodeState& state, Color at_rest) {
  if (state.status != Status::kIdle) return palette.Of(state.status);
  return state.before != Status::kIdle ? palette.Of(state.before) : at_rest;
}

void PaintNode(const Ui& ui, ImDrawList& list, const Scene& scene, const SceneNode& node,
               const NodeLook& look) {
  NodePainter(ui, list, scene, node, look).Paint();
}

Box ToggleBox(const NodeLook& look) {
  const float right = look.box.max.x - 5 * look.zoom;
  const float top = look.box.min.y + 3 * look.zoom;
  return {{right - 18 * look.zoom, top}, {right, top + 18 * look.zoom}};
}

Box ChipBox(const NodeLook& look) {
  const float width = std::min(look.box.width(), 84 * look.zoom);
  const float center = look.box.center().x;
  const float bottom = look.box.max.y;
  return {{center - width / 2, bottom - 16 * look.zoom}, {center + width / 2, bottom}};
}

}  // namespace coppice::editor
