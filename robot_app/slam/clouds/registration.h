// Lays one turn of the 3-D lidar upon another: how the robot stood to where it stood then. In steps
// from coarse to fine by ICP from points to surfaces, from a guess of how it is turned, and with
// what says whether that can be trusted: how much of both lies upon each other, how well, and
// whether the surfaces that hold the robot in the weakest direction do. Along a corridor those are
// its far end and what is seen through doors: where they do not agree, it is another place, though
// nearly all of both clouds may; in a bare corridor there are none, and any place fits.
//
// Y. Chen, G. Medioni: Object modelling by registration of multiple range images, IVC 10 (1992).
// The robot stays on its floor, so position and yaw are searched. The only place that includes PCL:
// its templates take half a minute to compile.
//
// Points are in base_link, z up from the floor [m]. Pure functions; any thread.
#ifndef COPPICE_ROBOT_APP_SLAM_CLOUDS_REGISTRATION_H_
#define COPPICE_ROBOT_APP_SLAM_CLOUDS_REGISTRATION_H_

#include <optional>

#include "robot_app/slam/clouds/cloud_descriptor.h"
#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

/// Of one length.
struct ThinCloud {
  CloudPoints points;
  CloudPoints normals;
};

/// What stands upright within `range`, a point in each cube of `leaf` [m], with the direction in
/// which the surface looks.
ThinCloud ThinOut(const CloudPoints& points, double leaf = 0.2, double range = 40);

struct RegistrationSettings {
  double near = 0.15;              ///< points so near to each other agree [m]
  double least_overlap = 0.7;      ///< share of either cloud that agrees
  double most_residual = 0.06;     ///< of those, along the normals, root of mean square [m]
  int least_hold = 40;             ///< points whose surfaces hold the weakest direction and agree,
  double least_hold_share = 0.45;  ///< and of all that hold it
  double most_way = 3;             ///< between the two places [m]
};

struct Registration {
  Pose3 relative = Pose3::Identity();  ///< base_link of the new cloud as seen from the old one's
  double overlap = 0;                  ///< of the worse of both
  double residual = 0;                 ///< [m]
  // Of the worse of both clouds, of the direction that is held the least:
  int hold = 0;           ///< points whose surfaces hold it and agree,
  double hold_share = 0;  ///< and of all that hold it
};

/// `guess` is where base_link of the new cloud may be, as seen from the old one's. Nothing: one
/// of them has hardly any points. Some 15 ms.
std::optional<Registration> Register(const ThinCloud& old_cloud, const ThinCloud& new_cloud,
                                     const Pose3& guess, const RegistrationSettings& settings = {});

/// Whether it is enough to close a loop.
bool IsSure(const Registration& registration, const RegistrationSettings& settings = {});

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_CLOUDS_REGISTRATION_H_
