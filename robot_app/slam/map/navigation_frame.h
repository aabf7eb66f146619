// Where a map of many sessions lies on the map that the robot navigates on, so that a place that is
// recognized in a picture can be told to the localization, and the grid be used by the navigation.
//
// Each map has a frame of its own, which begins where its first session began. Key frames at which
// the localization was sure say how it lies; a few of them that contradict the others do not count.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_NAVIGATION_FRAME_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_NAVIGATION_FRAME_H_

#include <memory>
#include <optional>
#include <vector>

#include "robot_app/slam/map/slam_map.h"

namespace coppice::robot::slam {

/// For each session: the pose of its map's frame in the frame of the navigation's map. Nothing
/// where no key frame of that map has a place; those that are null are not asked.
std::vector<std::optional<Pose3>> OnNavigationMap(
    const SessionGraph& graph, const std::vector<std::shared_ptr<const KeyFrame>>& key_frames);

/// The same map with all poses in the frame of the navigation's map, where that is known.
SlamMap MovedToNavigationMap(SlamMap map);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_NAVIGATION_FRAME_H_
