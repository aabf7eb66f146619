#include "robot_app/perception/detection/suppression.h"

#include <algorithm>

namespace coppice::robot::perception {

std::vector<Sighting> Suppress(std::vector<Sighting> sightings, double share, double nested) {
  std::stable_sort(sightings.begin(), sightings.end(), [](const Sighting& a, const Sighting& b) {
    return a.confidence > b.confidence;
  });
  const auto is_person = [](const Sighting& s) { return s.kind == SightingKind::kPerson; };
  std::vector<Sighting> kept;
  for (const Sighting& sighting : sightings) {
    const bool is_known = std::any_of(kept.begin(), kept.end(), [&](const Sighting& surer) {
      return is_person(surer) == is_person(sighting) && (Overlap(surer.box, sighting.box) > share ||
                                                         Nesting(surer.box, sighting.box) > nested);
    });
    if (!is_known) kept.push_back(sighting);
  }
  return kept;
}

}  // namespace coppice::robot::perception
