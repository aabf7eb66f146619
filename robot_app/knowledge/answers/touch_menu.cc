#include "robot_app/knowledge/answers/touch_menu.h"

#include <algorithm>
#include <set>

#include "robot_app/knowledge/store/queries.h"

namespace coppice::robot::knowledge {
namespace {

// Subjects, and the keys of their labels.
constexpr std::pair<const char*, const char*> kDays[] = {
    {"today", "day_today"},
    {"tomorrow", "day_tomorrow"},
    {"day_after_tomorrow", "day_after_tomorrow"}};

// The slot that a step chooses; nothing for a fixed one.
std::optional<Kind> SlotOf(const std::string& step) {
  if (step.size() < 3 || step.front() != '{') return std::nullopt;
  return KindOf(std::string_view(step).substr(1, step.size() - 2));
}

}  // namespace

// Fills the slots of the path's choices.
bool TouchMenu::Follows(const IntentRow& row, const std::vector<std::string>& path,
                        Request& request) const {
  if (path.size() > row.touch.size()) return false;
  request = {row.intent, {}};
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!SlotOf(row.touch[i])) {
      if (path[i] != row.touch[i]) return false;
      continue;
    }
    const auto choices = Choices(row.touch[i], request);
    const bool is_there = std::any_of(choices.begin(), choices.end(),
                                      [&](const TouchButton& one) { return one.step == path[i]; });
    if (!is_there) return false;
    request.slots.push_back({*SlotOf(row.touch[i]), path[i]});
  }
  return true;
}

std::vector<TouchButton> TouchMenu::Choices(const std::string& step, const Request& request) const {
  const std::optional<Kind> kind = SlotOf(step);
  if (!kind) return {{step, texts_.Word("button_" + step)}};
  std::vector<TouchButton> buttons;
  if (*kind == Kind::kDay) {
    for (const auto& [day, label] : kDays)
      buttons.push_back({day, Capitalized(texts_.Word(label))});
    return buttons;
  }
  std::vector<std::string> subjects;
  const Slot* const category = request.Find(Kind::kCategory);
  if (*kind == Kind::kPlace && category) {
    for (const Place& place : PlacesOf(database_, category->subject)) subjects.push_back(place.id);
  } else {
    std::set<std::string> seen;
    for (const Name& name : Names(database_)) {
      if (name.kind == *kind && seen.insert(name.subject).second) subjects.push_back(name.subject);
    }
  }
  for (const std::string& subject : subjects) {
    buttons.push_back({subject, Capitalized(NameOf(database_, *kind, subject, language_))});
  }
  return buttons;
}

TouchScreen TouchMenu::After(const std::vector<std::string>& path) const {
  TouchScreen screen;
  std::set<std::string> seen;
  for (const IntentRow& row : table_) {
    Request request;
    if (!Follows(row, path, request)) continue;
    if (row.touch.size() == path.size()) {
      request.slots.erase(
          std::remove_if(request.slots.begin(), request.slots.end(),
                         [&row](const Slot& slot) { return !row.Takes(slot.kind); }),
          request.slots.end());
      screen.request = request;
      continue;
    }
    if (!seen.insert(row.touch[path.size()]).second) continue;
    for (TouchButton& button : Choices(row.touch[path.size()], request)) {
      screen.buttons.push_back(std::move(button));
    }
  }
  return screen;
}

}  // namespace coppice::robot::knowledge
