#include "robot_app/knowledge/understanding/told_meaning.h"

#include <algorithm>

namespace coppice::robot::knowledge {
namespace {

constexpr std::size_t kMostChoices = 3;

// The best names first, those that may be meant as well behind.
std::vector<Slot> SubjectsOf(const NamedSlot& slot, const Understander& understander) {
  std::vector<Slot> subjects;
  double best = 0;
  for (const Candidate& candidate : understander.FindNames(slot.words, {slot.kind})) {
    if (candidate.fit < kSureName || candidate.value < kAsGoodName * best) continue;
    best = std::max(best, candidate.value);
    if (subjects.size() < kMostChoices) subjects.push_back({candidate.kind, candidate.subject});
  }
  return subjects;
}

bool Needs(const IntentRow& row, Kind kind) {
  return std::find(row.needs.begin(), row.needs.end(), kind) != row.needs.end();
}

}  // namespace

std::optional<Understanding> CheckedMeaning(const ToldMeaning& told, const IntentTable& table,
                                            const Understander& understander) {
  if (!told.intent) return Understanding{};
  const auto row = std::find_if(table.begin(), table.end(), [&](const IntentRow& candidate) {
    return candidate.intent == *told.intent;
  });
  if (row == table.end()) return std::nullopt;
  Understanding meant{Verdict::kUnderstood, {*told.intent, {}}, {}, {}};
  bool has_needed = row->needs.empty();
  for (const NamedSlot& slot : told.slots) {
    const std::vector<Slot> subjects = SubjectsOf(slot, understander);
    const bool is_needed = Needs(*row, slot.kind);
    if (!row->Takes(slot.kind) || meant.request.Find(slot.kind) != nullptr) return std::nullopt;
    if (subjects.empty() || (subjects.size() > 1 && !is_needed)) return std::nullopt;
    if (is_needed && has_needed) return std::nullopt;
    has_needed = has_needed || is_needed;
    if (subjects.size() > 1) {
      meant.verdict = Verdict::kAmbiguous;
      meant.choices = subjects;
    } else {
      auto& slots = meant.request.slots;
      slots.insert(is_needed ? slots.begin() : slots.end(), subjects.front());
    }
  }
  if (!has_needed) meant.verdict = Verdict::kMissing;
  return meant;
}

}  // namespace coppice::robot::knowledge
