// What the classes of a network mean to the robot.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_CLASSES_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_CLASSES_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::perception {

/// By the index of the class; nothing: of no interest.
using NetworkClasses = std::vector<std::optional<SightingKind>>;

/// A name a line, in any case, words joined by a space, "_" or "-". None that the robot knows is a
/// problem that tells the names it knows.
Expected<NetworkClasses> ParseClasses(const std::string& text);

/// Of a network without names: the 80 of COCO, whose first one are people, or people alone.
Expected<NetworkClasses> UsualClasses(int count);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_CLASSES_H_
