#include "robot_app/app/crowd_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice::robot {
namespace {

using coppice_msgs::Person;

constexpr double kMoves = 0.3;       // faster [m/s]
constexpr double kRemembered = 0.5;  // unseen for longer [s]

}  // namespace

void CrowdFigures::Add(const coppice_msgs::People& people) {
  int now = 0;
  for (const Person& person : people.people) {
    std::uint8_t& mask = masks[person.id];
    if (person.mask != Person::MASK_UNKNOWN) mask = person.mask;
    if (person.unseen_for > kRemembered) continue;
    ++now;
    moving += std::hypot(person.velocity.x, person.velocity.y) > kMoves ? 1 : 0;
  }
  ++looks;
  seen += now;
  most = std::max(most, now);
}

double CrowdFigures::crowd() const { return looks > 0 ? static_cast<double>(seen) / looks : 0; }

double CrowdFigures::liveliness() const {
  return seen > 0 ? static_cast<double>(moving) / static_cast<double>(seen) : 0;
}

std::string ToText(const CrowdFigures& figures) {
  const auto count = [&](std::uint8_t mask) {
    return std::count_if(figures.masks.begin(), figures.masks.end(),
                         [mask](const auto& person) { return person.second == mask; });
  };
  char text[192];
  std::snprintf(text, sizeof(text),
                "%zu followed, faces: %td with mask, %td without; crowd: %.1f at once, at most %d, "
                "%.0f %% of them moving",
                figures.masks.size(), count(Person::WITH_MASK), count(Person::WITHOUT_MASK),
                figures.crowd(), figures.most, 100 * figures.liveliness());
  return text;
}

}  // namespace coppice::robot
