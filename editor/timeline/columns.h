// What of a run falls into each column of pixels of a timeline.
#ifndef COPPICE_EDITOR_TIMELINE_COLUMNS_H_
#define COPPICE_EDITOR_TIMELINE_COLUMNS_H_

#include <cstddef>
#include <vector>

#include "editor/timeline/run.h"
#include "editor/timeline/time_view.h"

namespace coppice::editor {

/// The ticks that hold in a column: from `first` up to and without `end`. Empty before the run and
/// behind it.
struct Column {
  std::size_t first = 0;
  std::size_t end = 0;
  bool is_empty() const { return first >= end; }
};

/// `run_end`: until when the last tick holds.
std::vector<Column> ColumnsOf(const Run& run, const TimeView& view, std::size_t count,
                              Time run_end);

/// Columns side by side in which a lane shows the same.
struct Bar {
  std::size_t first_column = 0;
  std::size_t end_column = 0;
  StatusSet statuses = 0;  ///< kIdle among others if it was idle at times
};

/// Only bars in which something but IDLE occurs.
std::vector<Bar> BarsOf(const Lane& lane, const std::vector<Column>& columns);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_COLUMNS_H_
