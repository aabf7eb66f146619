// What the mouse is doing on the canvas, from one frame to the next.
#ifndef COPPICE_EDITOR_CANVAS_GESTURE_H_
#define COPPICE_EDITOR_CANVAS_GESTURE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "editor/scene/scene.h"
#include "editor/theme/geometry.h"

namespace coppice::editor {

/// What is being dragged.
struct Drag {
  std::vector<std::uint32_t> nodes;  ///< of this scene, rising; empty: something new
  std::string label;                 ///< painted beside the mouse
};

struct Gesture {
  enum class Kind : std::uint8_t {
    kNone,
    kPressed,    ///< a button is down; it may become one of the others
    kPan,        ///< the canvas follows the mouse
    kRectangle,  ///< what is inside becomes selected
    kDrag,       ///< nodes are being carried
    kCancelled   ///< until the button is let go
  };
  Kind kind = Kind::kNone;
  Point start;                   ///< in the world
  std::uint32_t node = kNoNode;  ///< that was below the mouse when the button went down
  Drag drag;                     ///< of kDrag
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_GESTURE_H_
