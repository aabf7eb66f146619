#include "bt_core/analysis/why/run_walk.h"

namespace coppice {

void WalkRun(const Recording& run, RunVisitor& visitor) {
  std::optional<HistoryFollower> follower;
  const auto& sections = run.sections();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Recording::Section& section = sections[i];
    if (!follower || !FollowsOn(section)) {
      follower.emplace(ShapeOf(run.trees()[section.tree]), section.state);
      visitor.OnSection(run.trees()[section.tree], section);
    }
    const std::size_t end =
        i + 1 < sections.size() ? sections[i + 1].first_tick : run.ticks().size();
    for (std::size_t k = section.first_tick; k < end; ++k) {
      const TickEvents events = run.EventsOf(k);
      visitor.OnTickBegin(events);
      follower->Apply(
          events, [&](const StatusChange& change) { visitor.OnChange(change, events); },
          [&](const Event& event) { visitor.OnEvent(event, events); });
      visitor.OnTickEnd(events);
    }
  }
}

}  // namespace coppice
