#include "editor/panels/run/run_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "editor/panels/widgets/panel.h"

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

std::string SentenceOf(const Statistics& figures, bool is_stretch, bool is_paused) {
  const auto seconds = [](Duration time) { return static_cast<double>(time.count()) * 1e-9; };
  const auto milliseconds = [&](Duration time) { return seconds(time) * 1e3; };
  char text[128];
  std::snprintf(text, sizeof(text),
                " of %.3f ms (p95 %.3f, max %.3f), one every %.1f ms, %llu lost",
                milliseconds(figures.tick_durations.p50), milliseconds(figures.tick_durations.p95),
                milliseconds(figures.tick_durations.max), milliseconds(figures.periods.p50),
                static_cast<unsigned long long>(figures.lost_ticks));
  std::string sentence = is_stretch ? "marked stretch: " : "whole run: ";
  sentence += Count(figures.ticks, "tick") + text;
  const bool was_paused = figures.paused > Duration(0);
  if (was_paused) sentence += ", paused for " + DurationText(seconds(figures.paused));
  if (is_paused) sentence += was_paused ? " and is paused now" : ", is paused now";
  return sentence;
}

std::string ShortNumber(const std::string& value) {
  constexpr std::size_t kLong = 8;  // characters
  constexpr double kSmall = 1e-6;   // from here to kLarge without powers of ten
  constexpr double kLarge = 1e15;
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  const bool is_short = value.size() <= kLong && value.find('e') == std::string::npos;
  const bool has_fraction = value.find_first_of(".e") != std::string::npos;
  if (is_short || !has_fraction || *end != '\0' || !std::isfinite(number)) return value;
  char text[32];
  const double size = std::abs(number);
  if (number != 0 && (size < kSmall || size >= kLarge)) {
    std::snprintf(text, sizeof(text), "%.6g", number);
    return text;
  }
  const int digits = size < 1 ? 0 : static_cast<int>(std::log10(size)) + 1;  // before the point
  std::snprintf(text, sizeof(text), "%.*f", std::max(6 - digits, 0), number);
  std::string shown = text;
  if (shown.find('.') == std::string::npos) return shown;
  shown.erase(shown.find_last_not_of('0') + 1);
  if (shown.back() == '.') shown.pop_back();
  return shown;
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
