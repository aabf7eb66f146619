// What in a range image is floor, and what stands on it.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_GROUND_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_GROUND_H_

#include <cstdint>
#include <vector>

#include "robot_app/perception/clouds/range_image.h"

namespace coppice::robot::perception {

enum class Surface : std::uint8_t {
  kNothing,   ///< the ray met nothing
  kFloor,     ///< where one can walk
  kStanding,  ///< between the floor and the height of a tall person
  kAbove,     ///< higher: ceilings, lamps
};

struct GroundOptions {
  float start = 0.15F;   ///< the floor begins within this height of where it should be [m]
  float slope = 0.07F;   ///< it rises and falls at most so steeply, as ramps for wheelchairs do
  float tallest = 2.1F;  ///< nobody is taller [m]
};

/// A value for each cell of the image. Column by column from the lowest ring up, as in
/// I. Bogoslavskyi and C. Stachniss, "Fast Range Image-Based Segmentation of Sparse 3D Laser
/// Scans for Online Operation", IROS 2016: what rises no steeper than `slope` from the floor before
/// it is floor, so ramps are too. `surfaces` may be that of before.
void FindGround(const RangeImage& image, const GroundOptions& options,
                std::vector<Surface>& surfaces);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_GROUND_H_
