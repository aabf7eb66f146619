#include "bt_nodes/recovery/node_repairs.h"

#include <algorithm>

namespace coppice::leaves {

NodeRepairs::Repair* NodeRepairs::Find(const std::string& node) {
  const auto found = std::find_if(repairs_.begin(), repairs_.end(),
                                  [&](const Repair& repair) { return repair.node == node; });
  return found == repairs_.end() ? nullptr : &*found;
}

void NodeRepairs::Blame(const HealthEntry& entry) {
  const std::string& name = entry.node.empty() ? entry.subject : entry.node;
  if (Repair* known = Find(name)) {
    known->is_blamed = true;
    return;
  }
  Repair repair;
  repair.node = name;
  repair.can_restart = !entry.node.empty();
  repairs_.push_back(std::move(repair));
}

std::vector<RepairOutcome> NodeRepairs::Update(Time now, const Health& health,
                                               std::string_view kinds) {
  for (Repair& repair : repairs_) repair.is_blamed = false;
  for (const HealthEntry& entry : health.entries) {
    if (entry.level >= HealthLevel::kError && ListsKind(kinds, entry.monitor)) Blame(entry);
  }
  std::vector<RepairOutcome> outcomes;
  for (Repair& repair : repairs_) Settle(now, repair, outcomes);
  const auto is_forgotten = [&](Repair& repair) {
    return !repair.is_blamed && repair.budget.used(now, options_.period) == 0;
  };
  repairs_.erase(std::remove_if(repairs_.begin(), repairs_.end(), is_forgotten), repairs_.end());
  return outcomes;
}

void NodeRepairs::Settle(Time now, Repair& repair, std::vector<RepairOutcome>& outcomes) const {
  const bool was_coming_up = repair.state == State::kComingUp;
  if (!repair.is_blamed) {
    if (was_coming_up) outcomes.push_back({repair.node, repair.attempt, true});
    repair.state = State::kWell;
    return;
  }
  if (repair.state == State::kWell) repair.state = State::kFaulty;
  if (!repair.can_restart) repair.state = State::kGivenUp;
  if (was_coming_up && now >= repair.until) {
    outcomes.push_back({repair.node, repair.attempt, false});
    repair.state = State::kFaulty;
  }
}

std::optional<RepairOutcome> NodeRepairs::Next(Time now) {
  for (Repair& repair : repairs_) {
    const bool is_due =
        repair.state == State::kFaulty || (repair.state == State::kGivenUp && now >= repair.until);
    if (!repair.is_blamed || !repair.can_restart || !is_due) continue;
    if (!repair.budget.Take(now, options_.times, options_.period)) {
      GiveUp(repair, now);
      continue;
    }
    repair.attempt = repair.budget.used(now, options_.period);
    return RepairOutcome{repair.node, repair.attempt, false};
  }
  return std::nullopt;
}

void NodeRepairs::Began(const std::string& node, Time now) {
  Repair* repair = Find(node);
  if (!repair) return;
  repair->state = State::kComingUp;
  repair->until = now + options_.grace;
}

void NodeRepairs::Refused(const std::string& node, Time now) {
  if (Repair* repair = Find(node)) GiveUp(*repair, now);
}

void NodeRepairs::GiveUp(Repair& repair, Time now) const {
  repair.state = State::kGivenUp;
  repair.until = now + options_.again;
}

bool NodeRepairs::is_busy() const {
  return std::any_of(repairs_.begin(), repairs_.end(), [](const Repair& repair) {
    return repair.is_blamed && repair.state != State::kGivenUp;
  });
}

bool NodeRepairs::has_faults() const {
  return std::any_of(repairs_.begin(), repairs_.end(),
                     [](const Repair& repair) { return repair.is_blamed; });
}

std::string NodeRepairs::given_up() const {
  std::string nodes;
  for (const Repair& repair : repairs_) {
    if (!repair.is_blamed || repair.state != State::kGivenUp) continue;
    nodes += (nodes.empty() ? "" : ", ") + repair.node;
  }
  return nodes;
}

}  // namespace coppice::leaves
