#include "editor/canvas/layout/node_metrics.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "editor/canvas/layout/value_lines.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr float kChipPadding = 5;
constexpr float kLongestTitle = 300;  // pixels at zoom 1; the rest is in the explanation

bool Contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

std::string_view ControlGlyph(std::string_view id) {
  if (Contains(id, "Parallel")) return icon::kDoubleArrows;
  if (Contains(id, "Fallback") || Contains(id, "Selector")) return "?";
  if (Contains(id, "Sequence")) return icon::kRightArrow;
  return icon::kFork;
}

std::string_view DecoratorGlyph(std::string_view id) {
  if (id == "Inverter") return "!";
  if (Contains(id, "Retry")) return icon::kRefresh;
  if (Contains(id, "Repeat") || Contains(id, "Loop") || Contains(id, "KeepRunning")) {
    return icon::kRepeat;
  }
  if (id == "Timeout") return icon::kClock;
  if (Contains(id, "Delay")) return icon::kHourglass;
  if (Contains(id, "Success")) return icon::kCheck;
  if (Contains(id, "Failure")) return icon::kTimes;
  return icon::kShield;
}

// Width at zoom 1.
float WidthOf(const Ui& ui, std::string_view text, const TextStyle& style) {
  return ui.Width(text, style) / ui.scale;
}

float PortWidth(const Ui& ui, const PortLine& port, float column, bool whole) {
  float value = 0;
  for (const std::string& line : ValueLines(port, whole)) {
    value = std::max(value, WidthOf(ui, line, {Face::kMono, metrics::kValueSize, 0}));
  }
  return column + metrics::kColumnGap + value + (port.key.empty() ? 0 : 2 * kChipPadding);
}

Point MeasureNameAlone(const Ui& ui, const SceneNode& node) {
  const TextStyle style = {Face::kBold, metrics::kNameAloneSize, 0};
  const NameLines lines = BreakName(node.name);
  const float width = std::max(WidthOf(ui, lines.first, style), WidthOf(ui, lines.second, style));
  const float glyph = HasGlyphBesideName(node) ? metrics::kNameAloneGlyph : 0;
  const float second = lines.second.empty() ? 0 : metrics::kNameAloneLine;
  return {std::ceil(glyph + width + 2 * metrics::kNameAlonePad),
          metrics::kNameAloneHeight + second};
}

}  // namespace

std::string_view GlyphOf(const SceneNode& node) { return GlyphOf(node.shape, node.id); }

std::string_view GlyphOf(Shape shape, std::string_view id) {
  switch (shape) {
    case Shape::kControl:
      return ControlGlyph(id);
    case Shape::kDecorator:
      return DecoratorGlyph(id);
    case Shape::kAction:
      return Contains(id, "Script") || Contains(id, "Blackboard") ? icon::kCode : icon::kBolt;
    case Shape::kCondition:
      return icon::kQuestion;
    case Shape::kSubTree:
      return icon::kSitemap;
    case Shape::kUnknown:
      return icon::kCogs;
  }
  return {};
}

std::string_view TypeLineOf(const SceneNode& node) {
  if (node.name == node.id) return {};
  if (node.id == "Sequence" || node.id == "Fallback" || node.id == "Parallel") return {};
  return node.id;
}

std::string ShownValue(std::string_view value) {
  std::string shown;
  std::size_t characters = 0;
  for (const char c : value) {
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U && ++characters > metrics::kValueColumns) {
      return shown + icon::kEllipsis;
    }
    shown += c == '\n' || c == '\t' || c == '\r' ? ' ' : c;
  }
  return shown;
}

NameLines BreakName(std::string_view name) {
  if (name.size() <= metrics::kNameAloneColumns) return {name, {}};
  const auto is = [](bool (*kind)(int), char c) { return kind(static_cast<unsigned char>(c)); };
  const auto upper = [](int c) { return std::isupper(c) != 0; };
  const auto letter = [](int c) { return std::isalnum(c) != 0 || c >= 0x80; };
  std::size_t best = 0;
  const auto longer = [&](std::size_t at) { return std::max(at, name.size() - at); };
  for (std::size_t i = 1; i + 1 < name.size(); ++i) {
    const bool capital = is(upper, name[i]) && !is(upper, name[i - 1]);
    const bool gap = !is(letter, name[i - 1]) && is(letter, name[i]);
    if ((capital || gap) && (best == 0 || longer(i) < longer(best))) best = i;
  }
  if (best == 0) return {name, {}};
  std::string_view first = name.substr(0, best);
  while (!first.empty() && first.back() == ' ') first.remove_suffix(1);
  return {first, name.substr(best)};
}

bool HasGlyphBesideName(const SceneNode& node) {
  return node.shape == Shape::kControl || node.shape == Shape::kDecorator;
}

float NameColumn(const Ui& ui, const Scene& scene, const SceneNode& node) {
  float width = 0;
  for (std::uint32_t i = 0; i < node.port_count; ++i) {
    const PortLine& port = scene.ports[node.first_port + i];
    const float arrow = port.direction == PortDirection::kOutput ? metrics::kArrow : 0;
    width = std::max(width, WidthOf(ui, port.name, {Face::kSans, metrics::kNameSize, 0}) + arrow);
  }
  return width;
}

float NoteHeight(const SceneNode& node, bool name_alone) {
  if (node.note.empty() || name_alone) return 0;
  const bool two = node.note.size() > metrics::kNoteColumns;
  return metrics::kNoteLine * (two ? 2.0F : 1.0F) + 6 + metrics::kNoteGap;
}

std::uint32_t RowsAbove(const Scene& scene, const SceneNode& node, std::uint32_t port, bool whole) {
  std::uint32_t rows = TypeLineOf(node).empty() ? 0 : 1;
  for (std::uint32_t i = 0; i < port; ++i) {
    rows += ValueLineCount(scene.ports[node.first_port + i], whole);
  }
  return rows;
}

NodeSizes MeasureNode(const Ui& ui, const Scene& scene, const SceneNode& node, bool whole) {
  const float name = WidthOf(ui, node.name, {Face::kBold, metrics::kTitleSize, 0});
  float title = metrics::kIcon + metrics::kStatus + 2 * metrics::kPad +
                (whole ? name : std::min(name, kLongestTitle));
  const bool leaf = node.shape == Shape::kAction || node.shape == Shape::kCondition ||
                    node.shape == Shape::kSubTree || node.shape == Shape::kUnknown;
  if (leaf && node.run_node != kNoNode) title += metrics::kElapsed;
  float body = WidthOf(ui, TypeLineOf(node), {Face::kSans, metrics::kNameSize, 0});
  const float column = NameColumn(ui, scene, node);
  for (std::uint32_t i = 0; i < node.port_count; ++i) {
    body = std::max(body, PortWidth(ui, scene.ports[node.first_port + i], column, whole));
  }
  const std::uint32_t lines = RowsAbove(scene, node, node.port_count, whole);
  const float height = metrics::kHeader +
                       (lines ? static_cast<float>(lines) * metrics::kLine + metrics::kBottom : 0);
  const float least = node.note.empty() ? 0 : metrics::kNoteWidth;
  const float note = NoteHeight(node, false);
  return {{std::ceil(std::max({title, body + 2 * metrics::kPad, least})), height + note},
          MeasureNameAlone(ui, node)};
}

}  // namespace coppice::editor
