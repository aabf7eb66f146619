// /people/sightings: what was seen in a picture, as a message and back.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_SIGHTING_MESSAGES_H_
#define COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_SIGHTING_MESSAGES_H_

#include <coppice_msgs/Sightings.h>

#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/perception/sightings/joined_sightings.h"

namespace coppice::robot::perception {

/// Without the header and the camera's own fields.
coppice_msgs::Sighting ToMessage(const PlacedSighting& placed);

/// A problem names what is no number or of no kind: then there are none.
Expected<std::vector<PlacedSighting>> FromMessage(const coppice_msgs::Sightings& message);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_SIGHTING_MESSAGES_H_
