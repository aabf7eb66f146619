#include "bt_core/analysis/told_tick.h"

namespace coppice {
namespace {

std::string TextOf(const Event& event) {
  if (event.text != EventText::kInjected || event.bytes.empty()) return std::string(event.bytes);
  return ToString(static_cast<Status>(event.bytes[0]));
}

}  // namespace

ToldTick TellTick(const TreeDescription& tree, HistoryFollower& follower, const TickEvents& events,
                  const std::vector<bool>& wanted) {
  ToldTick tick{events.tick, events.start, events.duration, events.result, events.is_whole, {}, {},
                {}};
  const auto is_wanted = [&](NodeIndex node) { return wanted.empty() || wanted[node]; };
  const auto on_change = [&](const StatusChange& change) {
    if (!is_wanted(change.node)) return;
    tick.changes.push_back({tree.nodes[change.node].path, change.from, change.to});
  };
  const auto on_event = [&](const Event& event) {
    const bool writes = event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
    if (writes && wanted.empty() && event.index < tree.slots.size()) {
      const DescribedSlot& slot = tree.slots[event.index];
      const bool is_known = event.writer < tree.nodes.size();
      tick.writes.push_back({slot.scope, slot.name, std::string(event.bytes),
                             is_known ? tree.nodes[event.writer].path : ""});
    } else if (event.code == EventCode::kText && is_wanted(event.node())) {
      tick.messages.push_back({tree.nodes[event.index].path, event.text, TextOf(event)});
    }
  };
  follower.Apply(events, on_change, on_event);
  return tick;
}

}  // namespace coppice
