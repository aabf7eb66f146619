#include "editor/panels/timeline/lane_painter.h"

#include <algorithm>
#include <cmath>

#include "editor/theme/contrast.h"

namespace coppice::editor {
namespace {

constexpr float kDimmed = 0.5F;
constexpr float kPale = 0.4F;
constexpr Status kByWeight[] = {Status::kFailure, Status::kRunning, Status::kSuccess,
                                Status::kSkipped};

// A full bar with its name. False if that does not fit.
bool PaintWord(const Ui& ui, ImDrawList& list, const Box& box, Status status, Color color) {
  const TextStyle style{Face::kBold, 9, WritingOn(color)};
  const std::string word = ToString(status);
  if (box.width() <= ui.Width(word, style) + 8 * ui.scale) return false;
  ui.Fill(list, box, color);
  ui.RowText(list, box.min + Point{4 * ui.scale, 0}, box.height(), word, style);
  return true;
}

// Whoever does not see the colours sees: RUNNING is a full bar, SUCCESS one on a line, FAILURE one
// that is cut along its middle, SKIPPED a thin one.
void PaintForm(const Ui& ui, ImDrawList& list, const Box& box, Status status, Color color) {
  const float line = std::max(std::round(box.height() / 6), 1.0F);
  const Color gap = Mix(color, ui.palette.panel, 0.75F);
  switch (status) {
    case Status::kSuccess:
      ui.Fill(list, box, color);
      ui.Fill(list, {{box.min.x, box.max.y - 2 * line}, {box.max.x, box.max.y - line}}, gap);
      return;
    case Status::kFailure: {
      ui.Fill(list, box, color);
      const float middle = std::round(box.center().y - line / 2);
      ui.Fill(list, {{box.min.x, middle}, {box.max.x, middle + line}}, gap);
      return;
    }
    case Status::kSkipped:
      ui.Fill(list, {{box.min.x, box.center().y - line}, {box.max.x, box.center().y + line}},
              color);
      return;
    default:
      ui.Fill(list, box, color);
  }
}

}  // namespace

Status WorstOf(StatusSet statuses) {
  for (const Status status : kByWeight) {
    if (statuses & SetOf(status)) return status;
  }
  return Status::kIdle;
}

void PaintBars(const Ui& ui, ImDrawList& list, const Box& box, const std::vector<Bar>& bars,
               std::size_t columns, float now_x) {
  const float step = box.width() / static_cast<float>(std::max<std::size_t>(columns, 1));
  for (const Bar& bar : bars) {
    const float left = box.min.x + step * static_cast<float>(bar.first_column);
    const float right = box.min.x + step * static_cast<float>(bar.end_column);
    const bool also_idle = bar.statuses & SetOf(Status::kIdle);
    const bool is_now = left <= now_x + 1 && right >= now_x - 1;
    const auto color_of = [&](Status status) {
      const bool pale = also_idle || status == Status::kSkipped;  // what did nothing is not loud
      return Mix(ui.palette.panel, ui.palette.Of(status), pale ? kPale : is_now ? 1.0F : kDimmed);
    };
    int kinds = 0;
    for (const Status status : kByWeight) kinds += (bar.statuses & SetOf(status)) != 0;
    if (kinds == 1 && !also_idle) {
      const Status status = WorstOf(bar.statuses);
      const Box whole = {{left, box.min.y}, {right, box.max.y}};
      if (PaintWord(ui, list, whole, status, color_of(status))) continue;
    }
    const float height = box.height() / static_cast<float>(kinds);
    float top = box.min.y;
    for (const Status status : kByWeight) {
      if (!(bar.statuses & SetOf(status))) continue;
      PaintForm(ui, list, {{left, top}, {right, top + height}}, status, color_of(status));
      top += height;
    }
  }
}

void PaintHatched(const Ui& ui, ImDrawList& list, const Box& box, Color color) {
  ui.Fill(list, box, Fade(color, 0.18F));
  list.PushClipRect(ToIm(box.min), ToIm(box.max), true);
  const float step = 6 * ui.scale;
  for (float x = box.min.x - box.height(); x < box.max.x; x += step) {
    list.AddLine({x, box.max.y}, {x + box.height(), box.min.y}, Fade(color, 0.6F), ui.scale);
  }
  list.PopClipRect();
}

Duration MarkDistance(Duration span, int most) {
  constexpr double kSteps[] = {1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3,  5e-3,  0.01, 0.02,
                               0.05, 0.1,  0.2,  0.5,  1,    2,    5,    10,    15,    30,   60,
                               120,  300,  600,  900,  1800, 3600, 7200, 14400, 43200, 86400};
  const double wanted = static_cast<double>(span.count()) * 1e-9 / std::max(most, 1);
  for (const double step : kSteps) {
    if (step >= wanted) return Duration(static_cast<Duration::rep>(step * 1e9));
  }
  return Duration(static_cast<Duration::rep>(wanted * 1e9));
}

}  // namespace coppice::editor
