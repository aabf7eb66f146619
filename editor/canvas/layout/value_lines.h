// The lines in which a port's value stands in its node. Scripts wrap: a statement begins a line,
// and a long one goes on below, set in. Everything else is one line on the canvas, where the mouse
// tells the rest; pictures have it all.
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_VALUE_LINES_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_VALUE_LINES_H_

#include <string>
#include <vector>

#include "editor/scene/scene.h"

namespace coppice::editor {

/// At least one line, each of at most 34 characters; a name of a key is never broken. `whole`:
/// nothing is left out, as on paper; otherwise a script has at most four lines.
std::vector<std::string> ValueLines(const PortLine& port, bool whole);

/// How many that are, without making them where there is one.
std::uint32_t ValueLineCount(const PortLine& port, bool whole);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_VALUE_LINES_H_
