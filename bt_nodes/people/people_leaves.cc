#include "bt_nodes/people/people_leaves.h"

#include <algorithm>
#include <cmath>

namespace coppice::leaves {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFacing = 0.1;    // nearer to straight ahead needs no turn [rad]
constexpr double kBehind = 0.8;    // to either side of straight behind [rad]
constexpr double kClose = 1.5;     // [m]
constexpr double kStanding = 0.3;  // no faster [m/s]
constexpr char kBlind[] = "perception does not tell who is around";

bool IsInSight(const SeenPerson& person) { return person.unseen_for <= kOldestSight; }

// What perception says, if it does.
const PeopleView* Fresh(const PeopleInput& people, Time now) {
  if (!people.has_value()) return nullptr;
  const double age = std::chrono::duration<double>(now - people->stamp).count();
  return age <= kOldestView ? &*people : nullptr;
}

}  // namespace

bool SeesPeople::Check() { return Fresh(people, now()) != nullptr; }

bool PersonInFront::Check() {
  const PeopleView* view = Fresh(people, now());
  if (view == nullptr) return Say(kBlind), false;
  const SeenPerson* nearest = view->Nearest([this](const SeenPerson& person) {
    return IsInSight(person) && person.distance() <= *distance &&
           std::abs(person.angle()) <= *angle && person.known_for >= *lasting;
  });
  if (nearest == nullptr) return false;
  id.Set(static_cast<int>(nearest->id));
  return true;
}

Status NearestPerson::Run() {
  const PeopleView* view = Fresh(people, now());
  if (view == nullptr) return Fail(kBlind);
  const SeenPerson* nearest = view->Nearest(IsInSight);
  if (nearest == nullptr) return Fail("nobody is around");
  id.Set(static_cast<int>(nearest->id));
  distance.Set(nearest->distance());
  angle.Set(nearest->angle());
  return Status::kSuccess;
}

Status CountPeople::Run() {
  const PeopleView* view = Fresh(people, now());
  if (view == nullptr) return Fail(kBlind);
  const auto count_if = [&](auto is_counted) {
    return static_cast<int>(
        std::count_if(view->people.begin(), view->people.end(), [&](const SeenPerson& person) {
          return person.distance() <= *distance && is_counted(person);
        }));
  };
  count.Set(count_if([](const SeenPerson&) { return true; }));
  with_mask.Set(count_if([](const SeenPerson& person) { return person.mask == Mask::kWith; }));
  without_mask.Set(
      count_if([](const SeenPerson& person) { return person.mask == Mask::kWithout; }));
  return Status::kSuccess;
}

bool FollowerBehind::Check() {
  const PeopleView* view = Fresh(people, now());
  if (view == nullptr) return Say(kBlind), false;
  return std::any_of(view->people.begin(), view->people.end(), [this](const SeenPerson& person) {
    return person.distance() <= *distance && kPi - std::abs(person.angle()) <= *angle &&
           person.unseen_for <= *patience;
  });
}

bool FollowerNear::IsNear(const SeenPerson& person) const {
  return person.distance() <= *distance && person.unseen_for <= *patience;
}

// A track that breaks off gets another number, and who was nearest at the beginning may have been
// somebody who went his way; somebody right behind the robot, else who stands close, is the one who
// follows it. Who walks ahead or passes by is not.
bool FollowerNear::Check() {
  const PeopleView* view = Fresh(people, now());
  if (view == nullptr) return Say(kBlind), false;
  const int known = id.Get();
  const SeenPerson* follower = view->Nearest([&](const SeenPerson& person) {
    return IsNear(person) && (known < 0 || static_cast<int>(person.id) == known);
  });
  if (follower == nullptr) {
    follower = view->Nearest([&](const SeenPerson& person) {
      return IsNear(person) && kPi - std::abs(person.angle()) <= kBehind;
    });
  }
  if (follower == nullptr) {
    follower = view->Nearest([&](const SeenPerson& person) {
      return IsNear(person) && person.distance() <= kClose && person.speed <= kStanding;
    });
  }
  if (follower == nullptr) return false;
  id.Set(static_cast<int>(follower->id));
  gap.Set(follower->distance());
  return true;
}

bool MaskMissing::Check() {
  const PeopleView* view = Fresh(people, now());
  if (view == nullptr) return Say(kBlind), false;
  std::set<std::uint32_t> around;
  const SeenPerson* found = nullptr;
  for (const SeenPerson& person : view->people) {
    if (told_.count(person.id) != 0) {
      around.insert(person.id);
    } else if (found == nullptr && person.mask == Mask::kWithout &&
               person.distance() <= *distance && IsInSight(person)) {
      found = &person;
    }
  }
  told_ = std::move(around);  // numbers are not given again: who is gone need not be remembered
  if (found == nullptr) return false;
  told_.insert(found->id);
  id.Set(static_cast<int>(found->id));
  return true;
}

void FacePerson::Begin(Sender<ActionResult> done) {
  const PeopleView* view = Fresh(people, now());
  const SeenPerson* nearest = view != nullptr ? view->Nearest(IsInSight) : nullptr;
  if (nearest == nullptr) {
    done.Send({false, view != nullptr ? "nobody is around" : kBlind});
  } else if (std::abs(nearest->angle()) < kFacing) {
    done.Send({true, ""});
  } else {
    navigator_.Rotate(nearest->angle(), *speed, done);
  }
}

}  // namespace coppice::leaves
