#include "editor/canvas/paint/node_lines.h"

#include <algorithm>
#include <string>
#include <vector>

#include "editor/canvas/layout/node_metrics.h"
#include "editor/canvas/layout/value_lines.h"
#include "editor/canvas/paint/node_painter.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

class LinesPainter {
 public:
  LinesPainter(Pen& pen, const Scene& scene, const SceneNode& node, const NodeLook& look)
      : pen_(pen), scene_(scene), node_(node), look_(look) {}

  void Paint(const Box& body) {
    const std::string_view type = TypeLineOf(node_);
    if (!type.empty()) {
      const Point at = body.min + Point{Z(metrics::kPad), Z(metrics::kHeader + 2)};
      pen_.RowText(at, Z(metrics::kLine), type,
                   Style(Face::kSans, metrics::kNameSize, colors().text_dim));
    }
    const float column = Z(NameColumn(pen_.ui, scene_, node_) + metrics::kColumnGap);
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      PaintPort(node_.first_port + i, PortBox(scene_, node_, look_, i), column);
    }
  }

 private:
  float Z(float pixels) const { return pixels * look_.zoom; }
  const Palette& colors() const { return pen_.ui.palette; }
  TextStyle Style(Face face, float size, Color color) const {
    return {face, Z(size) / pen_.ui.scale, color};
  }

  void PaintPort(std::uint32_t number, const Box& row, float column) {
    const PortLine& port = scene_.ports[number];
    const Point at = row.min;
    pen_.RowText(at, Z(metrics::kLine), port.name,
                 Style(Face::kSans, metrics::kNameSize, colors().text_dim));
    Point value_at = at + Point{column, 0};
    if (port.direction == PortDirection::kOutput) {
      const TextStyle arrow = Style(Face::kSans, metrics::kValueSize, colors().text_dim);
      pen_.RowText(value_at - Point{Z(12), 0}, Z(metrics::kLine), icon::kRightArrow, arrow);
    }
    const std::vector<std::string> lines = ValueLines(port, look_.whole_values);
    if (!port.key.empty()) {
      const std::string value = look_.port_values ? look_.port_values->Of(number) : std::string();
      const std::string& text = value.empty() ? lines.front() : value;
      return PaintChip(port, text, {value_at, row.max});
    }
    for (const std::string& line : lines) {
      pen_.RowText(value_at, Z(metrics::kLine), line,
                   Style(Face::kMono, metrics::kValueSize, colors().text));
      value_at.y += Z(metrics::kLine);
    }
  }

  // A value that is longer than its key is cut: nodes keep their sizes while it changes.
  void PaintChip(const PortLine& port, const std::string& value, const Box& room) {
    const Point at = room.min;
    const bool lit = !look_.lit_value.empty() && look_.lit_value == port.value;
    const Color key = colors().OfKey(port.key);
    const TextStyle style = Style(Face::kMono, metrics::kValueSize, lit ? colors().node_body : key);
    const Box chip = {at + Point{0, Z(2)},
                      at + Point{std::min(pen_.Width(value, style) + Z(10), room.width() + Z(1)),
                                 Z(metrics::kLine - 2)}};
    pen_.FillBox(chip, lit ? key : Mix(colors().node_body, key, 0.16F), Z(4));
    pen_.FrameBox(chip, Mix(colors().node_body, key, lit ? 1.0F : 0.5F), Z(4));
    pen_.RowText(at + Point{Z(5), 0}, Z(metrics::kLine), value, style, chip.width() - Z(10) + 1);
  }

  Pen& pen_;
  const Scene& scene_;
  const SceneNode& node_;
  const NodeLook& look_;
};

}  // namespace

void PaintNodeLines(Pen& pen, const Scene& scene, const SceneNode& node, const NodeLook& look,
                    const Box& body) {
  LinesPainter(pen, scene, node, look).Paint(body);
}

}  // namespace coppice::editor
