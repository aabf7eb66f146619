// The frame that all tiles share: a header with a title, and a body that scrolls.
#ifndef COPPICE_EDITOR_PANELS_PANEL_H_
#define COPPICE_EDITOR_PANELS_PANEL_H_

#include <functional>
#include <string>
#include <string_view>

#include "editor/look/ui.h"

namespace coppice::editor {

inline constexpr float kPanelHeader = 24;  ///< pixels at scale 1
inline constexpr float kRowHeight = 21;

/// Draws header and background into `box` and then, inside a scrolling child window, the body.
void Panel(const Ui& ui, const std::string& path, const Box& box, std::string_view title,
           std::string_view note, const std::function<void()>& body);

/// A row of the full width of the current child window.
struct Row {
  Box box;
  bool clicked = false;
  bool hovered = false;
  bool visible = false;  ///< rows out of sight need not be painted
};
Row NextRow(const Ui& ui, const std::string& path, bool selected, float height = kRowHeight);

/// A line of dim text: what to do when there is nothing to show.
void Hint(const Ui& ui, std::string_view text);

/// A bar between two tiles that can be dragged. Returns how far it was dragged in this frame.
float Splitter(const Ui& ui, const std::string& path, const Box& box, bool vertical);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_PANEL_H_
