#include "robot_app/deployment/figures/figures.h"

#include <algorithm>
#include <numeric>

namespace coppice::robot::deployment {
namespace {

constexpr double kHour = 3600;
// Gaps of the feedback that the scripts take for standing.
constexpr double kShortestGap = 30, kLongestGap = 400;

double HoursOf(const Interval& interval) { return SecondsOf(interval) / kHour; }

double HoursOnDuty(const Journal& journal, const Interval& interval) {
  double seconds = 0;
  for (const Interval& duty : journal.duties) seconds += SecondsIn(interval, duty);
  return seconds / kHour;
}

void CountSpans(const Journal& journal, Figures& figures) {
  for (const Span& span : journal.spans) {
    const double hours = HoursOf(span.when);
    if (IsUndocked(span.activity)) figures.undocked += hours;
    if (span.activity == Activity::kMoving) figures.moving += hours;
    if (span.activity == Activity::kCharging || span.activity == Activity::kFull) {
      figures.charging += hours;
      figures.extra_charging += HoursOnDuty(journal, span.when);
    }
  }
  figures.moving_by_gaps = figures.undocked;
  for (const Interval& gap : journal.stands) {
    const double seconds = SecondsOf(gap);
    if (seconds >= kShortestGap && seconds <= kLongestGap) figures.moving_by_gaps -= HoursOf(gap);
  }
}

void CountRequests(const Journal& journal, Figures& figures) {
  figures.requests = static_cast<int>(journal.requests.size());
  double minutes = 0;
  for (const Request& request : journal.requests) {
    if (!request.is_fixed) continue;
    ++figures.answered;
    minutes += SecondsOf({request.asked, request.closed}) / 60;
  }
  if (figures.answered > 0) figures.answer_minutes = minutes / figures.answered;
}

void CountDockings(const Journal& journal, Figures& figures) {
  for (const Docking& docking : journal.dockings) {
    figures.dockings += docking.attempts;
    figures.good_dockings += docking.has_current;
    ++figures.docking_episodes;
    figures.good_docking_episodes += docking.has_current;
  }
}

}  // namespace

double Lifetimes::sum() const { return std::accumulate(hours.begin(), hours.end(), 0.0); }
double Lifetimes::mean() const {
  return hours.empty() ? 0 : sum() / static_cast<double>(hours.size());
}
double Lifetimes::most() const {
  return hours.empty() ? 0 : *std::max_element(hours.begin(), hours.end());
}

Lifetimes LifetimesOf(const Journal& journal) {
  Lifetimes lifetimes;
  Time from = journal.span.from;
  const auto end_at = [&](Time to) {
    const Interval life{from, to};
    lifetimes.hours.push_back((SecondsOf(life) - WeekendSeconds(life)) / kHour);
    from = to;
  };
  for (const UnplannedStop& stop : journal.stops) end_at(stop.at);
  end_at(journal.span.to);
  return lifetimes;
}

double Figures::autonomy() const {
  return working_days == 0 ? 0 : 100 * moving / working_days / kWorkday;
}
double Figures::autonomy_by_gaps() const {
  return working_days == 0 ? 0 : 100 * moving_by_gaps / working_days / kWorkday;
}

Figures FiguresOf(const Journal& journal) {
  Figures figures;
  figures.working_days = static_cast<int>(journal.duties.size());
  CountSpans(journal, figures);
  figures.distance = journal.distance / 1000;
  figures.lifetimes = LifetimesOf(journal);
  for (const leaves::RecoveryCount& count : leaves::CountRecoveries(journal.recoveries)) {
    figures.recoveries.push_back(
        {count.recovery, count.begun, count.helped, count.helped_strictly});
  }
  CountDockings(journal, figures);
  CountRequests(journal, figures);
  figures.stops = static_cast<int>(journal.stops.size());
  return figures;
}

}  // namespace coppice::robot::deployment
