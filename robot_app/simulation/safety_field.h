// What the safety circuit of the front lidar looks at: the free way straight ahead of the
// footprint.
#ifndef COPPICE_ROBOT_APP_SIMULATION_SAFETY_FIELD_H_
#define COPPICE_ROBOT_APP_SIMULATION_SAFETY_FIELD_H_

#include <vector>

#include "robot_app/simulation/scene/ray_caster.h"

namespace coppice::robot::simulation {

/// How far a round robot of `radius` at `base` (map frame) can drive straight on until its edge
/// meets something that the lidar at `mounting` (in base_link) sees, in metres, at most `reach`.
/// Negative if something is already inside the footprint. No noise, no state.
double FrontGap(const Pose2& base, const Pose2& mounting, double radius, double reach,
                const RayCaster& still, const std::vector<Disc>& moving);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SAFETY_FIELD_H_
