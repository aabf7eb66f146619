// Recognizes that the robot has come back to where it was before: the end of a loop.
//
// What the robot has seen on its last metres is laid upon what it saw when it was last near here,
// by a search over all places and headings around (place_search.h). A loop is closed only where one
// place fits, and fits well: in a corridor that looks alike along its length there is none.
#ifndef COPPICE_ROBOT_APP_MAPPING_LOOP_CLOSURE_H_
#define COPPICE_ROBOT_APP_MAPPING_LOOP_CLOSURE_H_

#include <optional>

#include "robot_app/mapping/key_frame.h"
#include "robot_app/mapping/pose_graph.h"

namespace coppice::robot::mapping {

/// How far off the newest pose may be.
struct PoseDoubt {
  double position = 0.3;  ///< [m]
  double yaw = 0.3;       ///< [rad]
};

/// The newest key frame as seen from an old one that lies near; nothing if there is none, or no
/// place within `doubt` fits for sure. Takes some 50 ms.
std::optional<PoseConstraint> FindLoopClosure(const KeyFrames& frames, const PoseDoubt& doubt,
                                              const MappingSettings& settings);

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_LOOP_CLOSURE_H_
