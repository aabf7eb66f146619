// A floor as sensors that look up and down see it.
#ifndef COPPICE_ROBOT_APP_SIMULATION_FLOOR_SCENE_H_
#define COPPICE_ROBOT_APP_SIMULATION_FLOOR_SCENE_H_

#include <vector>

#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/scene/scene.h"

namespace coppice::robot::simulation {

/// What stands still: walls, furniture, the boxes of blocked places, door leaves, and the landmark
/// of the charging station where it is now, or none. `door_open` and `place_blocked` have one for
/// each of the floor's doors and places.
StillScene MakeStillScene(const Floor& floor, const std::vector<bool>& door_open,
                          const std::vector<bool>& place_blocked,
                          const std::optional<Triangle>& landmark);

/// The same with everything as it is at the start.
StillScene MakeStillScene(const Floor& floor);

/// The landmark when the station was moved by `moved` as seen by a docked robot; nothing if the
/// floor's station has none.
std::optional<Triangle> LandmarkOf(const Floor& floor, const Pose2& moved = {});

/// The same as sound meets it: with the panes of glass.
StillScene WithGlass(StillScene still, const Floor& floor);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_FLOOR_SCENE_H_
