// Which stretch of a run the timeline shows. Like a camera: it follows the end of the run, or stays
// where the user has put it.
#ifndef COPPICE_EDITOR_TIMELINE_TIME_VIEW_H_
#define COPPICE_EDITOR_TIMELINE_TIME_VIEW_H_

#include "bt_core/base/clock.h"

namespace coppice::editor {

class TimeView {
 public:
  Time begin() const { return begin_; }
  Time end() const { return begin_ + span_; }
  Duration span() const { return span_; }

  /// Once per frame: `run_end` is the end of what there is. While it follows, that lies a little
  /// left of the right edge.
  void Follow(Time run_end);
  bool is_following() const { return is_following_; }
  void StartFollowing() { is_following_ = true; }

  /// Moves by a part of the span; negative: into the past. Ends following.
  void Pan(double part);
  /// `factor` < 1: closer. The moment at `part` of the span, in [0, 1], stays where it is; while it
  /// follows, the end does.
  void Zoom(double factor, double part);
  /// Shows that stretch, with a little room around. Ends following.
  void Fit(Time begin, Time end);
  /// Moves as little as needed for the moment to be seen. Ends following if it has to move.
  void Reveal(Time time);

  /// The moment at a part of the span, and back.
  Time At(double part) const;
  double PartOf(Time time) const;

 private:
  Time begin_{};
  Duration span_ = std::chrono::seconds(10);
  bool is_following_ = true;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_TIME_VIEW_H_
