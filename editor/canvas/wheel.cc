#include "editor/canvas/wheel.h"

#include <cmath>

namespace coppice::editor {
namespace {

constexpr float kPanStep = 60;
constexpr float kZoomStep = 1.15F;

}  // namespace

WheelMove MoveOf(const WheelTurn& turn, bool wheel_zooms) {
  WheelMove move;
  move.pan.x = turn.by.x * kPanStep;
  if (turn.shift) {
    move.pan.x += turn.by.y * kPanStep;
  } else if (turn.ctrl != wheel_zooms) {
    move.zoom = std::pow(kZoomStep, turn.by.y);
  } else {
    move.pan.y = turn.by.y * kPanStep;
  }
  return move;
}

std::string_view WheelHint(bool wheel_zooms) {
  return wheel_zooms ? "The wheel zooms; with Shift or Ctrl it moves the canvas."
                     : "The wheel moves the canvas, sideways with Shift; with Ctrl it zooms.";
}

}  // namespace coppice::editor
