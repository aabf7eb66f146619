// How large the boxes are and what stands in them, at zoom 1. One place for measuring and painting,
// so that no text is ever clipped.
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_NODE_METRICS_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_NODE_METRICS_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "editor/canvas/layout/tree_layout.h"
#include "editor/scene/scene.h"
#include "editor/theme/geometry.h"
#include "editor/theme/ui.h"

namespace coppice::editor::metrics {

inline constexpr float kHeader = 24;     ///< height of the title row
inline constexpr float kLine = 19;       ///< height of a port's row
inline constexpr float kPad = 9;         ///< left and right of all rows
inline constexpr float kIcon = 20;       ///< left part of the title row
inline constexpr float kStatus = 20;     ///< right part of the title row
inline constexpr float kElapsed = 40;    ///< for the seconds of a running leaf
inline constexpr float kBottom = 5;      ///< below the last row
inline constexpr float kChip = 20;       ///< height of the row that stands for collapsed children
inline constexpr float kColumnGap = 10;  ///< between a port's name and its value
inline constexpr float kArrow = 8;       ///< more than that, for the arrow of an output port

inline constexpr std::size_t kNoteColumns = 34;   ///< characters in a line of a note
inline constexpr std::size_t kMostNoteLines = 2;  ///< longer notes are cut
inline constexpr float kNoteLine = 14;
inline constexpr float kNoteGap = 3;      ///< between a note and its node
inline constexpr float kNoteWidth = 150;  ///< least width of a node with a note

inline constexpr float kNoteSize = 10;
inline constexpr float kTitleSize = 13;
inline constexpr float kNameAloneSize = 20;           ///< of a name that stands alone
inline constexpr float kNameAloneHeight = 26;         ///< of its first line
inline constexpr float kNameAloneLine = 22;           ///< of its second one
inline constexpr float kNameAlonePad = 10;            ///< left and right of it
inline constexpr float kNameAloneGlyph = 22;          ///< room for the glyph of an inner node
inline constexpr std::size_t kNameAloneColumns = 14;  ///< characters; longer names have two lines
inline constexpr std::size_t kValueColumns = 34;      ///< characters in a line of a value
inline constexpr float kNameSize = 11;
inline constexpr float kValueSize = 11;

}  // namespace coppice::editor::metrics

namespace coppice::editor {

/// The glyph left of a node's name; of a type with that ID.
std::string_view GlyphOf(Shape shape, std::string_view id);
std::string_view GlyphOf(const SceneNode& node);

/// The node type, if the name and the glyph do not say it already; else empty.
std::string_view TypeLineOf(const SceneNode& node);

/// A port's value as it is shown: one line, not too long.
std::string ShownValue(std::string_view value);

/// A name that stands alone: in two lines if it is long and there is a place to break it, before a
/// capital letter or at what is no letter.
struct NameLines {
  std::string_view first, second;  ///< `second` is empty if there is one line
};
NameLines BreakName(std::string_view name);

/// Whether a glyph stands beside a name that stands alone: of nodes that have children. Leaves are
/// told by colour and shape.
bool HasGlyphBesideName(const SceneNode& node);

/// Width of the column of port names of a node at zoom 1.
float NameColumn(const Ui& ui, const Scene& scene, const SceneNode& node);

/// Height of the note above the node with the gap below it; 0 without a note, and where names stand
/// alone: there it is a tab in the corner.
float NoteHeight(const SceneNode& node, bool name_alone);

/// Rows below the title and above the port's value (value_lines.h); of port_count: all rows.
std::uint32_t RowsAbove(const Scene& scene, const SceneNode& node, std::uint32_t port, bool whole);

/// The sizes of a node at zoom 1, without the row for collapsed children. They are the same on
/// every screen but for the rounding of its fonts. `whole`: nothing is cut (ValueLines).
NodeSizes MeasureNode(const Ui& ui, const Scene& scene, const SceneNode& node, bool whole);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_NODE_METRICS_H_
