// One box for each thing that is seen.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_SUPPRESSION_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_SUPPRESSION_H_

#include <vector>

#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::perception {

/// Of sightings that have more than `share` in common (Overlap), or of which one lies in the other
/// by more than `nested` (Nesting; 2: never), the surest stays: of people among people, of faces of
/// any kind among faces. Surest first.
std::vector<Sighting> Suppress(std::vector<Sighting> sightings, double share, double nested = 2);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_SUPPRESSION_H_
