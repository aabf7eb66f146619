// What several detectors see in one picture becomes people for the tracker: box, face and body of
// one person are one detection.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_JOINED_SIGHTINGS_H_
#define COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_JOINED_SIGHTINGS_H_

#include <vector>

#include "robot_app/perception/detection/sighting.h"
#include "robot_app/perception/sightings/place.h"
#include "robot_app/perception/tracking/tracker.h"

namespace coppice::robot::perception {

struct PlacedSighting {
  Sighting sighting;
  Place place;  ///< kNothing: not known where
};

/// Those of one picture. Who has no place is left out; places nearer to each other than a body are
/// one person: where the surer one for a body says, and with the mask that the face says.
std::vector<Detection> Join(std::vector<PlacedSighting> sightings);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_JOINED_SIGHTINGS_H_
