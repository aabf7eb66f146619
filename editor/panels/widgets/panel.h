// The frame that all tiles share: a header with a title, and a body that scrolls.
#ifndef COPPICE_EDITOR_PANELS_WIDGETS_PANEL_H_
#define COPPICE_EDITOR_PANELS_WIDGETS_PANEL_H_

#include <functional>
#include <string>
#include <string_view>

#include "editor/keys/command_table.h"
#include "editor/theme/ui.h"

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
  bool right_clicked = false;
  bool hovered = false;
  bool visible = false;  ///< rows out of sight need not be painted
};
Row NextRow(const Ui& ui, const std::string& path, bool selected, float height = kRowHeight);

/// A paragraph of dim text: what to do when there is nothing to show.
void Hint(const Ui& ui, std::string_view text);

/// A row that is as high as its text needs, which is broken into lines rather than cut.
Row TextRow(const Ui& ui, const std::string& path, std::string_view text, const TextStyle& style);

/// An explanation beside the mouse, broken into lines.
void Tooltip(const Ui& ui, std::string_view text);

/// What a click on the last item runs, with its keys, while the mouse is over it.
void ExplainCommand(const Ui& ui, const CommandTable& commands, std::string_view id);

/// While it lives, rows of a menu that a panel's body opens stand as far apart as those of others.
class MenuSpacing {
 public:
  explicit MenuSpacing(const Ui& ui);
  ~MenuSpacing();
  MenuSpacing(const MenuSpacing&) = delete;
  MenuSpacing& operator=(const MenuSpacing&) = delete;
};

/// Without line ends, and with one blank where there are several, as they are in XML.
std::string InOneLine(std::string_view text);

/// "1 node", "2 nodes".
std::string Count(std::size_t count, const std::string& what);

/// A bar between two tiles that can be dragged. Returns how far it was dragged in this frame.
float Splitter(const Ui& ui, const std::string& path, const Box& box, bool vertical);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_WIDGETS_PANEL_H_
