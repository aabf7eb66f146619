// Who is around the robot: a value on the blackboard, fed from what perception tells.
#ifndef COPPICE_BT_NODES_PEOPLE_PEOPLE_VIEW_H_
#define COPPICE_BT_NODES_PEOPLE_PEOPLE_VIEW_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/value.h"

namespace coppice::leaves {

enum class Mask : std::uint8_t { kUnknown = 0, kWith = 1, kWithout = 2 };

/// Somebody, as seen from the robot: base_link, x forward, y left (REP-103).
struct SeenPerson {
  std::uint32_t id = 0;   ///< never given to anybody else
  double x = 0, y = 0;    ///< [m]
  double speed = 0;       ///< over the floor [m/s]
  double known_for = 0;   ///< since the first sight [s]
  double unseen_for = 0;  ///< since the last one [s]
  Mask mask = Mask::kUnknown;

  double distance() const;  ///< from the robot's middle [m]
  double angle() const;     ///< 0: straight ahead, positive: to the left [rad]
};

struct PeopleView {
  Time stamp{};  ///< of the tree's clock, when it arrived; zero: never
  std::vector<SeenPerson> people;

  /// The nearest of those for whom `is_wanted(person)` holds; null if there is nobody.
  template <typename IsWanted>
  const SeenPerson* Nearest(IsWanted is_wanted) const;
};

template <typename IsWanted>
const SeenPerson* PeopleView::Nearest(IsWanted is_wanted) const {
  const SeenPerson* nearest = nullptr;
  for (const SeenPerson& person : people) {
    if (!is_wanted(person)) continue;
    if (nearest == nullptr || person.distance() < nearest->distance()) nearest = &person;
  }
  return nearest;
}

}  // namespace coppice::leaves

/// Text form: JSON, {"stamp":NS,"people":[{"id":3,"x":1.200,"y":...}]}; numbers with three digits
/// behind the point. The editor shows it as a table.
template <>
struct coppice::ValueTraits<coppice::leaves::PeopleView> {
  static constexpr const char* kName = "PeopleView";
  static bool Parse(std::string_view text, leaves::PeopleView& out);
  static std::string Print(const leaves::PeopleView& value);
};

#endif  // COPPICE_BT_NODES_PEOPLE_PEOPLE_VIEW_H_
