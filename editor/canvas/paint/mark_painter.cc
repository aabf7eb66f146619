#include "editor/canvas/paint/mark_painter.h"

#include <algorithm>

#include "editor/theme/contrast.h"
#include "editor/theme/icons.h"

namespace coppice::editor {

void PaintMarks(Pen& pen, const NodeLook& look) {
  const std::uint8_t marks = look.state.marks;
  if (marks == kNoMark) return;
  const Palette& colors = pen.ui.palette;
  const float scale = std::max(look.zoom, 0.6F * pen.ui.scale);
  const Point at = {look.box.min.x - 11 * scale, look.box.center().y};
  if (marks & kStopMark) {
    pen.Disc(at, 9 * scale, colors.running);
    pen.Disc(at, 7.5F * scale, colors.canvas);
    pen.FrameBox({look.box.min - Point{3, 3} * scale, look.box.max + Point{3, 3} * scale},
                 colors.running, 7 * scale, 3 * scale);
  }
  if (marks & (kBreakpointMark | kBreakpointOffMark)) {
    pen.Disc(at, 5.5F * scale, colors.failure);
    if (!(marks & kBreakpointMark)) pen.Disc(at, 3.5F * scale, colors.canvas);
  }
  if (!(marks & kFaultMark)) return;
  const Box flag = {{look.box.min.x, look.box.min.y - 17 * scale},
                    {look.box.min.x + 58 * scale, look.box.min.y - 2 * scale}};
  const Color fault = Mix(colors.canvas, colors.error, 0.8F);
  pen.FillBox(flag, fault, 3 * scale);
  pen.RowText({flag.min.x + 4 * scale, flag.min.y}, flag.height(),
              std::string(icon::kWarning) + " fault",
              {Face::kBold, 10 * scale / pen.ui.scale, WritingOn(fault)}, flag.width() - 6 * scale);
}

}  // namespace coppice::editor
