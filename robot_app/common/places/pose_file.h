// The last pose that was certain, in a file: one line "x y yaw" in metres and radians.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_POSE_FILE_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_POSE_FILE_H_

#include <optional>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot {

/// Nothing if there is no such file or it does not hold a pose.
std::optional<Pose2D> LoadPose(const std::string& file);

/// Replaces the file at once: whoever reads it sees the old or the new pose, also after a power
/// failure.
Outcome SavePose(const std::string& file, const Pose2D& pose);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_POSE_FILE_H_
