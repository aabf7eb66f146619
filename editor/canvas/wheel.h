// What the wheel of the mouse, or two fingers on a trackpad, do to the canvas.
//
// They pan and Ctrl zooms, as in the timeline and in all that scrolls: two fingers can go sideways,
// and no tree jumps away below a hand that only rests on the wheel. Whoever has a wheel and large
// trees may have it the other way round.
#ifndef COPPICE_EDITOR_CANVAS_WHEEL_H_
#define COPPICE_EDITOR_CANVAS_WHEEL_H_

#include <string_view>

#include "editor/theme/geometry.h"

namespace coppice::editor {

/// How far it was turned: x to the left, y up; with the modifier keys that are held.
struct WheelTurn {
  Point by;
  bool ctrl = false;
  bool shift = false;  ///< up and down are left and right
};

struct WheelMove {
  Point pan;       ///< of what is seen [pixels at scale 1]
  float zoom = 1;  ///< factor
};

/// `wheel_zooms`: without Ctrl, and with it pans.
WheelMove MoveOf(const WheelTurn& turn, bool wheel_zooms);

/// A sentence that says so.
std::string_view WheelHint(bool wheel_zooms);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_WHEEL_H_
