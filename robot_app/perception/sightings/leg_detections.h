// Legs in a scan of the planar laser as the tracker takes them.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_LEG_DETECTIONS_H_
#define COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_LEG_DETECTIONS_H_

#include "robot_app/common/pose2d.h"
#include "robot_app/perception/legs/leg_finder.h"
#include "robot_app/perception/tracking/tracker.h"

namespace coppice::robot::perception {

/// Somebody whom the laser at `laser` saw, in the frame that `laser` is given in. What looks like
/// legs once does so in the next scan too, so no scan is surer than 80 %.
Detection ToDetection(const SeenLegs& person, const Pose2D& laser);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_LEG_DETECTIONS_H_
