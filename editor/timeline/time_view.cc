#include "editor/timeline/time_view.h"

#include <algorithm>

namespace coppice::editor {
namespace {

constexpr Duration kShortest = std::chrono::microseconds(10);
constexpr Duration kLongest = std::chrono::hours(24 * 365);
constexpr double kRoom = 0.03;  // of the span, right of the end of the run

Duration Times(double factor, Duration time) {
  return Duration(static_cast<Duration::rep>(factor * static_cast<double>(time.count())));
}

}  // namespace

void TimeView::Follow(Time run_end) {
  // A run that is shorter than the view begins at its left end.
  if (is_following_)
    begin_ = std::max(run_end - Times(1 - kRoom, span_), Time{} - Times(kRoom, span_));
}

void TimeView::Pan(double part) {
  begin_ += Times(part, span_);
  is_following_ = false;
}

void TimeView::Zoom(double factor, double part) {
  if (is_following_) part = 1 - kRoom;
  const Time fixed = At(part);
  span_ = std::clamp(Times(factor, span_), kShortest, kLongest);
  begin_ = fixed - Times(part, span_);
}

void TimeView::Fit(Time begin, Time end) {
  span_ = std::clamp(Times(1 + 2 * kRoom, end - begin), kShortest, kLongest);
  begin_ = begin - Times(kRoom, span_);
  is_following_ = false;
}

void TimeView::Reveal(Time time) {
  const double part = PartOf(time);
  if (part >= 0 && part <= 1) return;
  begin_ = time - Times(part < 0 ? 2 * kRoom : 1 - 2 * kRoom, span_);
  is_following_ = false;
}

Time TimeView::At(double part) const { return begin_ + Times(part, span_); }

double TimeView::PartOf(Time time) const {
  return static_cast<double>((time - begin_).count()) / static_cast<double>(span_.count());
}

}  // namespace coppice::editor
