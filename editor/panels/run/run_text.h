// How times and ticks of a run are written, and small curves.
#ifndef COPPICE_EDITOR_PANELS_RUN_RUN_TEXT_H_
#define COPPICE_EDITOR_PANELS_RUN_RUN_TEXT_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/analysis/statistics.h"
#include "editor/theme/ui.h"
#include "editor/timeline/run.h"

namespace coppice::editor {

/// "0:04.220", "1:02:03.250": since the beginning of the run.
std::string AxisText(Time time);

/// A number with six digits at most, for tables; any other text as it is. "0.43199999999999994" is
/// "0.432".
std::string ShortNumber(const std::string& value);

/// "tick 84 (0:04.220)", with the robot's own number of the tick.
std::string TickText(const Run& run, std::size_t tick);

/// The figures of all ticks of a run, or of a marked stretch of it. They know the pauses that have
/// ended; `is_paused`: another one goes on.
std::string SentenceOf(const Statistics& figures, bool is_stretch, bool is_paused);

/// Numbers from left to right, the smallest at the bottom; a hole where there is none.
void PaintCurve(const Ui& ui, ImDrawList& list, const Box& box,
                const std::vector<std::optional<double>>& numbers);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_RUN_RUN_TEXT_H_
