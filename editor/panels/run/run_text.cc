#include "editor/panels/run/run_text.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace coppice::editor {

std::string AxisText(Time time) {
  const long long milliseconds = std::max<long long>(ToNanoseconds(time) / 1000000, 0);
  const long long seconds = milliseconds / 1000;
  char text[64];
  if (seconds >= 3600) {
    std::snprintf(text, sizeof(text), "%lld:%02lld:%02lld.%03lld", seconds / 3600,
                  seconds / 60 % 60, seconds % 60, milliseconds % 1000);
  } else {
    std::snprintf(text, sizeof(text), "%lld:%02lld.%03lld", seconds / 60, seconds % 60,
                  milliseconds % 1000);
  }
  return text;
}

std::string ShortNumber(const std::string& value) {
  constexpr std::size_t kLong = 8;  // characters
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  const bool has_fraction = value.find('.') != std::string::npos;
  if (value.size() <= kLong || !has_fraction || *end != '\0') return value;
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", number);
  return text;
}

std::string TickText(const Run& run, std::size_t tick) {
  return "tick " + std::to_string(run.recording().ticks()[tick].number) + " (" +
         AxisText(run.TimeOf(tick)) + ")";
}

void PaintCurve(const Ui& ui, ImDrawList& list, const Box& box,
                const std::vector<std::optional<double>>& numbers) {
  std::optional<double> least;
  std::optional<double> most;
  for (const std::optional<double>& number : numbers) {
    if (!number) continue;
    least = std::min(least.value_or(*number), *number);
    most = std::max(most.value_or(*number), *number);
  }
  if (!least || numbers.size() < 2) return;
  const float pad = 4 * ui.scale;
  const float height = box.height() - 2 * pad;
  const double span = *most > *least ? *most - *least : 1;
  const float step = box.width() / static_cast<float>(numbers.size());
  std::optional<float> before;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float x = box.min.x + step * static_cast<float>(i);
    std::optional<float> y;
    if (numbers[i]) {
      const double part = *most > *least ? (*numbers[i] - *least) / span : 0.5;
      y = box.max.y - pad - static_cast<float>(part) * height;
      if (before && *before != *y) list.AddLine({x, *before}, {x, *y}, ui.palette.accent, ui.scale);
      list.AddLine({x, *y}, {x + step, *y}, ui.palette.accent, 1.5F * ui.scale);
    }
    before = y;
  }
}

}  // namespace coppice::editor
