#include "bt_nodes/visitors/visitor_leaves.h"

#include <chrono>
#include <cmath>

#include "bt_nodes/people/people_leaves.h"

namespace coppice::leaves {
namespace {

double SecondsSince(Time then, Time now) {
  return std::chrono::duration<double>(now - then).count();
}

}  // namespace

// Numbers are not given again: who is gone need not be remembered.
void VisitorArrived::ForgetWhoHasGone(const PeopleView& view) {
  std::set<std::uint32_t> around;
  for (const SeenPerson& person : view.people) {
    if (greeted_.count(person.id) != 0) around.insert(person.id);
  }
  greeted_ = std::move(around);
}

bool VisitorArrived::IsBefore(const SeenPerson& person) const {
  return person.unseen_for <= kOldestSight && person.distance() <= *distance &&
         std::abs(person.angle()) <= *angle && person.known_for >= *lasting;
}

bool VisitorArrived::Check() {
  if (!HasArrived()) return false;
  language.Set(visitor.has_value() ? visitor->language : Visitor().language);
  return true;
}

// Who touches the display is the one before it, and is greeted once.
bool VisitorArrived::HasArrived() {
  const int touches = visitor.has_value() ? visitor->touches : 0;
  const bool touched = touches != touches_;
  touches_ = touches;
  const bool sees = people.has_value() && SecondsSince(people->stamp, now()) <= kOldestView;
  if (!sees) return touched;
  ForgetWhoHasGone(*people);
  const SeenPerson* nearest =
      people->Nearest([this](const SeenPerson& person) { return IsBefore(person); });
  const bool is_new = nearest != nullptr && greeted_.insert(nearest->id).second;
  return is_new || (touched && nearest == nullptr);
}

bool VisitorTalks::Check() {
  if (!visitor.has_value() || visitor->heard == Time{}) return false;
  const Time end =
      visitor->heard + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(*quiet));
  if (now() >= end) return false;
  WakeAt(end);
  return true;
}

bool GuideRequested::Check() {
  if (!visitor.has_value() || visitor->request == 0) return false;
  if (SecondsSince(visitor->asked, now()) > *patience) return false;
  request.Set(visitor->request);
  place.Set(visitor->place);
  language.Set(visitor->language);
  return true;
}

}  // namespace coppice::leaves
