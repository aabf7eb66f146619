#include "editor/timeline/columns.h"

#include <algorithm>

namespace coppice::editor {

std::vector<Column> ColumnsOf(const Run& run, const TimeView& view, std::size_t count,
                              Time run_end) {
  std::vector<Column> columns(count);
  if (run.size() == 0) return columns;
  const Time start = run.TimeOf(0);
  const auto border = [&](std::size_t i) {
    return view.At(static_cast<double>(i) / static_cast<double>(count));
  };
  Time left = border(0);
  for (std::size_t i = 0; i < count; ++i) {
    const Time right = border(i + 1);
    if (right > start && left <= run_end) {
      columns[i] = {run.TickAt(left), run.TickAt(right - Duration(1)) + 1};
    }
    left = right;
  }
  return columns;
}

std::vector<Bar> BarsOf(const Lane& lane, const std::vector<Column>& columns) {
  std::vector<Bar> bars;
  constexpr StatusSet kNothing = SetOf(Status::kIdle);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const StatusSet seen = lane.Seen(columns[i].first, columns[i].end);
    if ((seen & ~kNothing) == 0) continue;
    const bool goes_on =
        !bars.empty() && bars.back().end_column == i && bars.back().statuses == seen;
    if (!goes_on) bars.push_back({i, i, seen});
    bars.back().end_column = i + 1;
  }
  return bars;
}

}  // namespace coppice::editor
