// What every panel and the canvas draw with: colours, fonts, time, and a handful of widgets that
// register themselves by path. Valid for one frame.
#ifndef COPPICE_EDITOR_THEME_UI_H_
#define COPPICE_EDITOR_THEME_UI_H_

#include <imgui.h>

#include <string>
#include <string_view>

#include "bt_core/base/clock.h"
#include "editor/theme/fonts.h"
#include "editor/theme/geometry.h"
#include "editor/theme/item_registry.h"
#include "editor/theme/palette.h"

namespace coppice::editor {

inline ImVec2 ToIm(Point p) { return {p.x, p.y}; }
inline Point FromIm(const ImVec2& p) { return {p.x, p.y}; }

/// How a text is to look. Sizes are in pixels at scale 1.
struct TextStyle {
  Face face = Face::kSans;
  float size = 12;
  Color color = 0xFFFFFFFF;
};

struct Ui {
  const Palette& palette;
  const Fonts& fonts;
  ItemRegistry& items;
  float scale;                 ///< of the screen
  double now;                  ///< seconds of the editor's own time, for animations
  Time clock;                  ///< of the clock that stamps statuses
  bool reduce_motion = false;  ///< nothing pulses, walks or glides
  bool at_rest = false;        ///< the run that is shown: it is stopped, over or in the past

  /// What tells that something runs walks and pulses.
  bool moves() const { return !reduce_motion && !at_rest; }

  float Width(std::string_view text, const TextStyle& style) const;

  /// The beginning that fits into `width`, with an ellipsis if something is cut off; empty if not
  /// even that fits.
  std::string Cut(std::string_view text, const TextStyle& style, float width) const;

  /// The end that fits into `width`, behind an ellipsis if something is cut off: of a path it says
  /// more than the beginning.
  std::string CutStart(std::string_view text, const TextStyle& style, float width) const;

  /// How high a paragraph of that width is.
  float ParagraphHeight(std::string_view text, const TextStyle& style, float width) const;

  /// Draws a text that is broken into lines of that width, with the top left corner at `at`.
  void Paragraph(ImDrawList& list, Point at, std::string_view text, const TextStyle& style,
                 float width) const;

  /// Draws with the top left corner at `at`.
  void Text(ImDrawList& list, Point at, std::string_view text, const TextStyle& style) const;

  /// In the vertical middle of a row. Cuts what is wider than `width` and ends it with an ellipsis;
  /// width 0: no limit. Returns the width of what was drawn.
  float RowText(ImDrawList& list, Point at, float row_height, std::string_view text,
                const TextStyle& style, float width = 0) const;

  /// An invisible button over `box` (in screen coordinates), registered as `path`.
  bool Hit(const std::string& path, const Box& box, bool* hovered = nullptr) const;

  /// A button with a text; `active` ones look pressed in.
  bool Button(const std::string& path, const Box& box, std::string_view text, bool active = false,
              Color tint = 0) const;

  void Fill(ImDrawList& list, const Box& box, Color color, float rounding = 0) const;
  /// `thickness` 0: a line of one pixel at scale 1.
  void Frame(ImDrawList& list, const Box& box, Color color, float rounding = 0,
             float thickness = 0) const;
};

/// The glyph of a status, empty for idle.
const char* GlyphOf(Status status);

/// "4.2 s", "3:05", "2:10:00".
std::string DurationText(double seconds);

/// Of a short time: "0.35 ms", "12 ms", "4.2 s".
std::string MillisecondsText(double milliseconds);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_UI_H_
